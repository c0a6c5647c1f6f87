package dev.lazyz.shading
import dev.lazyz.Fragment
import dev.lazyz.world.NormalMap
internal class NormalReader private constructor(private val map: MapReader, private val scale: Float) {
    fun apply(fragment: Fragment) { map.read(fragment)[0] * scale }
    companion object { fun of(normalMap: NormalMap?): NormalReader? = normalMap?.let { NormalReader(MapReader.of(it.map)!!, it.scale) } }
}
