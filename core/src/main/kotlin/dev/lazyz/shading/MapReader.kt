package dev.lazyz.shading

import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.TextureMap
import kotlin.math.sqrt

/** Reads a map at the coordinates of a fragment. Immutable and thread safe. */
internal class MapReader private constructor(map: TextureMap) {
    private val texture = map.texture
    private val isSecond = map.uvSet == 1
    private val transform = map.transform
    private val isTransformed = !map.transform.isIdentity

    /** Stores the components at the fragment in its [Fragment.texel], and returns it. */
    fun read(fragment: Fragment): FloatArray {
        if (isSecond) {
            read(
                fragment.u2, fragment.v2, fragment.du2dx, fragment.dv2dx, fragment.du2dy, fragment.dv2dy,
                fragment.texel,
            )
        } else {
            read(fragment.u, fragment.v, fragment.dudx, fragment.dvdx, fragment.dudy, fragment.dvdy, fragment.texel)
        }
        return fragment.texel
    }

    /** Stores the components at fragment [i] of [batch] in [out]. */
    fun read(batch: FragmentBatch, i: Int, out: FloatArray) = if (isSecond) {
        read(batch.u2[i], batch.v2[i], batch.du2dx[i], batch.dv2dx[i], batch.du2dy[i], batch.dv2dy[i], out)
    } else {
        read(batch.u[i], batch.v[i], batch.dudx[i], batch.dvdx[i], batch.dudy[i], batch.dvdy[i], out)
    }

    private fun read(
        u: Float,
        v: Float,
        dudx: Float,
        dvdx: Float,
        dudy: Float,
        dvdy: Float,
        out: FloatArray,
    ) = if (isTransformed) {
        texture.sample(
            transform.u(u, v),
            transform.v(u, v),
            transform.uu * dudx + transform.uv * dvdx,
            transform.vu * dudx + transform.vv * dvdx,
            transform.uu * dudy + transform.uv * dvdy,
            transform.vu * dudy + transform.vv * dvdy,
            out,
        )
    } else {
        texture.sample(u, v, dudx, dvdx, dudy, dvdy, out)
    }

    companion object {
        /** Returns a reader for [map], or null if there is none. */
        fun of(map: TextureMap?): MapReader? = map?.let { MapReader(it) }
    }
}

/** Changes the normal of a fragment by a normal map (contract rule 6.9). Immutable and thread safe. */
internal class NormalReader private constructor(private val map: MapReader, private val scale: Float) {
    /** Replaces the normal of [fragment]. */
    fun apply(fragment: Fragment) = apply(
        map.read(fragment), fragment.normalX, fragment.normalY, fragment.normalZ,
        fragment.tangentX, fragment.tangentY, fragment.tangentZ, fragment.tangentW,
    ) { x, y, z ->
        fragment.normalX = x
        fragment.normalY = y
        fragment.normalZ = z
    }

    /** Stores the normal of fragment [i] of [batch] in element i of [x], [y] and [z]; [texel] is scratch memory. */
    fun apply(batch: FragmentBatch, i: Int, x: FloatArray, y: FloatArray, z: FloatArray, texel: FloatArray) {
        map.read(batch, i, texel)
        apply(
            texel, batch.normalX[i], batch.normalY[i], batch.normalZ[i],
            batch.tangentX[i], batch.tangentY[i], batch.tangentZ[i], batch.tangentW[i],
        ) { nx, ny, nz ->
            x[i] = nx
            y[i] = ny
            z[i] = nz
        }
    }

    /** Passes the changed normal to [use], or nothing if the normal does not change. */
    private inline fun apply(
        texel: FloatArray,
        normalX: Float,
        normalY: Float,
        normalZ: Float,
        tangentX: Float,
        tangentY: Float,
        tangentZ: Float,
        tangentW: Float,
        use: (Float, Float, Float) -> Unit,
    ) {
        TangentFrame.of(normalX, normalY, normalZ, tangentX, tangentY, tangentZ) { nx, ny, nz, tx, ty, tz ->
            // The normal of the map, in the space of tangent, bitangent and normal
            val right = (2f * texel[0] - 1f) * scale
            val up = (2f * texel[1] - 1f) * scale * (if (tangentW < 0f) -1f else 1f)
            val out = 2f * texel[2] - 1f
            use(
                right * tx + up * (ny * tz - nz * ty) + out * nx,
                right * ty + up * (nz * tx - nx * tz) + out * ny,
                right * tz + up * (nx * ty - ny * tx) + out * nz,
            )
        }
    }

    companion object {
        fun of(normalMap: NormalMap?): NormalReader? =
            normalMap?.let { NormalReader(MapReader.of(it.map)!!, it.scale) }
    }
}

/** The directions of a surface at a fragment. */
internal object TangentFrame {
    /**
     * Passes the unit normal, and the unit tangent at a right angle to it, to [use]; nothing if one of them has no
     * length.
     */
    inline fun of(
        normalX: Float,
        normalY: Float,
        normalZ: Float,
        tangentX: Float,
        tangentY: Float,
        tangentZ: Float,
        use: (nx: Float, ny: Float, nz: Float, tx: Float, ty: Float, tz: Float) -> Unit,
    ) {
        val length = sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ)
        val nx = normalX / length
        val ny = normalY / length
        val nz = normalZ / length
        val along = nx * tangentX + ny * tangentY + nz * tangentZ
        var tx = tangentX - along * nx
        var ty = tangentY - along * ny
        var tz = tangentZ - along * nz
        val extent = sqrt(tx * tx + ty * ty + tz * tz)
        if (!(length > 0f && extent > 0f)) return
        tx /= extent
        ty /= extent
        tz /= extent
        use(nx, ny, nz, tx, ty, tz)
    }
}
