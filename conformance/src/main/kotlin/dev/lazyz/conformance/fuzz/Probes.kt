package dev.lazyz.conformance.fuzz

import java.io.ByteArrayInputStream
import java.io.DataInputStream
import java.lang.reflect.InvocationTargetException

/** What counts the branches of code that a rendering reaches. Not thread safe. */
internal interface Probes {
    /** How many probes were reached in all the time between [forget] and [take]. */
    val reached: Int

    /** Forgets what was reached since the last [take]. */
    fun forget()

    /** Returns how many probes were reached since [forget] for the first time. */
    fun take(): Int
}

/**
 * The probes of JaCoCo's agent, if Java was started with it: one on each branch of the classes that its option
 * `includes` names. It is found by its name, so that nobody needs it who does not want it.
 */
internal class AgentProbes private constructor(private val agent: Any, private val methods: Class<*>) : Probes {
    private val seen = HashMap<Long, BooleanArray>()

    override var reached = 0
        private set

    override fun forget() {
        methods.getMethod("reset").invoke(agent)
    }

    override fun take(): Int {
        val before = reached
        val data = methods.getMethod("getExecutionData", Boolean::class.java).invoke(agent, true) as ByteArray
        read(DataInputStream(ByteArrayInputStream(data)))
        return reached - before
    }

    /** Reads JaCoCo's format of execution data: blocks, each of which begins with its kind. */
    private fun read(data: DataInputStream) {
        while (true) {
            when (val kind = data.read()) {
                -1 -> return
                HEADER -> check(data.readInt() == FORMAT) { "another format of JaCoCo's execution data" }
                SESSION -> data.readUTF().also { repeat(2) { data.readLong() } }
                CLASS -> readClass(data)
                else -> error("an unknown block of JaCoCo's execution data: $kind")
            }
        }
    }

    private fun readClass(data: DataInputStream) {
        val id = data.readLong()
        data.readUTF()
        val ever = data.readCount().let { count -> seen.getOrPut(id) { BooleanArray(count) } }
        var bits = 0
        for (i in ever.indices) {
            bits = if (i % Byte.SIZE_BITS == 0) data.readUnsignedByte() else bits shr 1
            if (bits and 1 == 0 || ever[i]) continue
            ever[i] = true
            reached++
        }
    }

    /** Reads a number of groups of 7 bits, the lowest first. */
    private fun DataInputStream.readCount(): Int {
        val byte = readUnsignedByte()
        return if (byte < 0x80) byte else byte and 0x7F or (readCount() shl 7)
    }

    companion object {
        private const val HEADER = 0x01
        private const val SESSION = 0x10
        private const val CLASS = 0x11

        /** The magic number, and the version. */
        private const val FORMAT = 0xC0C0_1007.toInt()

        /** Returns the probes of the agent of this JVM; null if there is none. */
        fun find(): Probes? = try {
            val loader = ClassLoader.getSystemClassLoader()
            val agent = loader.loadClass("org.jacoco.agent.rt.RT").getMethod("getAgent").invoke(null)
            AgentProbes(agent, loader.loadClass("org.jacoco.agent.rt.IAgent"))
        } catch (_: ClassNotFoundException) {
            null
        } catch (_: InvocationTargetException) {
            null // The class is there, but the agent was not started
        }
    }
}
