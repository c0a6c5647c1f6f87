package dev.lazyz.scenes.gltf

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64

/** Puts glTF files together: numbers go into one buffer, and the rest is JSON by hand. */
internal class GltfFiles {
    private var buffer = ByteArray(0)
    private val views = ArrayList<String>()
    private val accessors = ArrayList<String>()

    /** Adds numbers and returns the accessor's number; [more] is added to its JSON. */
    fun accessor(type: String, componentType: Int, numbers: List<Number>, more: String = ""): Int {
        val view = view(encode(componentType, numbers))
        val count = numbers.size / mapOf("SCALAR" to 1, "VEC2" to 2, "VEC3" to 3, "VEC4" to 4).getValue(type)
        accessors.add("""{"bufferView":$view,"componentType":$componentType,"count":$count,"type":"$type"$more}""")
        return accessors.size - 1
    }

    /** Adds an accessor as it is written. */
    fun accessor(json: String): Int = accessors.size.also { accessors.add(json) }

    /** Adds bytes and returns the buffer view's number; [more] is added to its JSON. */
    fun view(bytes: ByteArray, more: String = ""): Int {
        buffer = buffer.copyOf((buffer.size + 3) / 4 * 4)
        views.add("""{"buffer":0,"byteOffset":${buffer.size},"byteLength":${bytes.size}$more}""")
        buffer += bytes
        return views.size - 1
    }

    fun encode(componentType: Int, numbers: List<Number>): ByteArray {
        val size = mapOf(BYTE to 1, UBYTE to 1, SHORT to 2, USHORT to 2, UINT to 4, FLOAT to 4).getValue(componentType)
        val bytes = ByteBuffer.allocate(size * numbers.size).order(ByteOrder.LITTLE_ENDIAN)
        for (number in numbers) {
            when (size) {
                1 -> bytes.put(number.toInt().toByte())
                2 -> bytes.putShort(number.toInt().toShort())
                else -> if (componentType == FLOAT) {
                    bytes.putFloat(number.toFloat())
                } else {
                    bytes.putInt(number.toLong().toInt())
                }
            }
        }
        return bytes.array()
    }

    /** Returns the file as JSON with an embedded buffer; [rest] is everything but buffers and accessors. */
    fun json(
        rest: String,
        uri: String = "data:application/octet-stream;base64," +
            Base64.getEncoder().encodeToString(buffer)
    ): String =
        """{"asset":{"version":"2.0"},$rest,"buffers":[{"byteLength":${buffer.size},"uri":"$uri"}],
            |"bufferViews":[${views.joinToString()}],"accessors":[${accessors.joinToString()}]}
        """.trimMargin()

    /** Returns the bytes of the buffer. */
    fun buffer(): ByteArray = buffer

    /** Returns the file in its binary form. */
    fun glb(rest: String): ByteArray {
        val text = json(rest).replace(Regex(",\"uri\":\"[^\"]*\""), "").toByteArray().let { pad(it, ' '.code.toByte()) }
        val data = pad(buffer, 0)
        val out = ByteBuffer.allocate(12 + 8 + text.size + 8 + data.size).order(ByteOrder.LITTLE_ENDIAN)
        out.putInt(0x46546C67).putInt(2).putInt(out.capacity())
        out.putInt(text.size).putInt(0x4E4F534A).put(text)
        out.putInt(data.size).putInt(0x004E4942).put(data)
        return out.array()
    }

    private fun pad(bytes: ByteArray, with: Byte) =
        bytes.copyOf((bytes.size + 3) / 4 * 4).also { it.fill(with, bytes.size, it.size) }

    companion object {
        const val BYTE = 5120
        const val UBYTE = 5121
        const val SHORT = 5122
        const val USHORT = 5123
        const val UINT = 5125
        const val FLOAT = 5126

        /** Everything but the mesh of a file that shows mesh 0. */
        const val ONE_NODE = """"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}]"""
    }
}
