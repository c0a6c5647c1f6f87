package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.gltf.animation.NodePose
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.NodeJson
import dev.lazyz.scenes.loading.PartNames
import org.joml.Matrix4d
import org.joml.Matrix4dc

/**
 * A node with its position in the world.
 *
 * @property node the node as stored in the file
 * @property index its number
 * @property toWorld transform from the node's space to world space; affine
 * @property path names from the root to the node, with `/` between them
 * @property isVisible whether its mesh and its light are shown, by `KHR_node_visibility` of the node and its ancestors
 */
internal class PlacedNode(
    val node: NodeJson,
    val index: Int,
    val toWorld: Matrix4dc,
    val path: String,
    val isVisible: Boolean,
)

/** Walks the nodes of the scene that was asked for, or of the default scene (section 3.5). */
internal class GltfNodes(private val document: GltfDocument, private val poses: Map<Int, NodePose>) {
    private val nodes = document.json.nodes
    private val rootToWorld = RelativeToCenter.toWorld(document)
    private val toWorld = HashMap<Int, Matrix4d>()
    private val parents: Map<Int, Int> by lazy {
        nodes.withIndex().flatMap { (i, node) -> children(node).filterNotNull().map { it to i } }.toMap()
    }

    /**
     * Returns the nodes of the default scene, each before its children. If the file has no default scene, returns all
     * nodes: the roots are those that are not a child of another node. Fails if a node is reached twice, because nodes
     * must form trees (3.5.2).
     */
    fun walk(): List<PlacedNode> {
        class Pending(
            val index: Int,
            val where: String,
            val toParent: Matrix4dc,
            val above: String,
            val isVisible: Boolean,
        )

        // An explicit stack, because a chain of nodes may be deeper than the call stack allows
        val pending = ArrayDeque<Pending>()
        for ((index, where) in roots().asReversed()) {
            document.source.step()
            pending.addLast(Pending(index, where, rootToWorld, "", true))
        }
        val seen = HashSet<Int>()
        val placed = ArrayList<PlacedNode>()
        while (pending.isNotEmpty()) {
            document.source.step()
            val next = pending.removeLast()
            val node = document.element(nodes, next.index, "nodes", next.where)
            if (!seen.add(next.index)) document.fail(next.where, "node ${next.index} has two parents or holds itself")
            val toWorld = Transforms.product(next.toParent, NodeTransforms.of(node, poses[next.index]))
            this.toWorld[next.index] = toWorld
            val path = PartNames.path(next.above, node.name)
            document.source.loading.decode(document.source, PartNames.bytes(path))
            val isVisible = next.isVisible && node.extension(VISIBILITY)?.get("visible") != false
            placed.add(PlacedNode(node, next.index, toWorld, path, isVisible))
            val children = children(node)
            for (i in children.indices.reversed()) {
                document.source.step()
                val where = "nodes[${next.index}].children[$i]"
                pending.addLast(Pending(children[i] ?: -1, where, toWorld, path, isVisible))
            }
        }
        return placed
    }

    /**
     * Returns the transform from a node's space to world space, also for a node that is not part of the scene. [where]
     * is the place that refers to the node. Fails if a node is its own ancestor.
     */
    fun toWorld(index: Int, where: String): Matrix4d {
        // Climb to the first ancestor whose transform is known, then come back down
        val unknown = LinkedHashSet<Int>()
        var next: Int? = index
        while (next != null && next !in toWorld) {
            document.source.step()
            document.element(nodes, next, "nodes", where)
            if (!unknown.add(next)) document.fail(where, "node $next holds itself")
            next = parents[next]
        }
        for (node in unknown.reversed()) {
            val toParent = NodeTransforms.of(checkNotNull(nodes[node]), poses[node])
            val parent = parents[node]?.let { toWorld.getValue(it) } ?: rootToWorld
            toWorld[node] = Transforms.product(parent, toParent)
        }
        return toWorld.getValue(index)
    }

    private fun roots(): List<Pair<Int, String>> {
        val wanted = document.source.loading.options.sceneNumber
        val index = wanted ?: document.json.scene
        if (index != null) {
            val scenes = document.json.scenes
            if (wanted != null && wanted >= scenes.size) {
                document.source.fail("scenes", "there is no scene $wanted; there are ${scenes.size}", "choose another")
            }
            val scene = document.element(scenes, index, "scenes", "scene")
            return scene.nodes.mapIndexed { i, node ->
                document.source.step()
                Pair(node ?: -1, "scenes[$index].nodes[$i]")
            }
        }
        val isChild = HashSet<Int?>()
        for (node in nodes) {
            document.source.step(1 + children(node).size)
            isChild += children(node)
        }
        return nodes.indices.filter { it !in isChild }.map {
            document.source.step()
            Pair(it, "nodes[$it]")
        }
    }

    private fun children(node: NodeJson?): List<Int?> = node?.children.orEmpty()

    companion object {
        /** The extension that hides nodes with their descendants. */
        const val VISIBILITY: String = "KHR_node_visibility"
    }
}

/** The extension `CESIUM_RTC`, which moves the whole model by a vector. */
internal object RelativeToCenter {
    const val NAME: String = "CESIUM_RTC"

    /** Returns the transform from the model's space to world space: a translation, the identity without [NAME]. */
    fun toWorld(document: GltfDocument): Matrix4d {
        val extension = document.json.extension(NAME) ?: return Matrix4d()
        val center = (extension["center"] as? List<*>).orEmpty().mapNotNull { (it as? Number)?.toDouble() }
        if (center.size != 3 || !center.all { it.isFinite() }) {
            document.fail("extensions.$NAME.center", "it must be three numbers")
        }
        return Matrix4d().translation(center[0], center[1], center[2])
    }
}

/**
 * The arithmetic of node transforms (section 3.5.3). It is written out here so that results are bit for bit the same on
 * every machine: JOML's own products may use fused multiply-add, depending on a JVM flag.
 */
internal object NodeTransforms {
    /**
     * Returns the transform from a node's space to its parent's: its matrix, or the product of translation, rotation
     * and scale. Values in [pose] replace those of the node.
     */
    fun of(node: NodeJson, pose: NodePose?): Matrix4d {
        val m = node.matrix
        if (m != null && pose?.isMoved != true) {
            // The fourth row is 0, 0, 0, 1 in every transform that the specification allows
            return Matrix4d(
                m[0].toDouble(), m[1].toDouble(), m[2].toDouble(), 0.0,
                m[4].toDouble(), m[5].toDouble(), m[6].toDouble(), 0.0,
                m[8].toDouble(), m[9].toDouble(), m[10].toDouble(), 0.0,
                m[12].toDouble(), m[13].toDouble(), m[14].toDouble(), 1.0,
            )
        }
        return of(
            pose?.translation ?: doubles(node.translation),
            pose?.rotation ?: doubles(node.rotation),
            pose?.scale ?: doubles(node.scale),
        )
    }

    /** Returns the product of a translation, a rotation as a unit quaternion, and a scale; null means none. */
    fun of(translation: DoubleArray?, rotation: DoubleArray?, scale: DoubleArray?): Matrix4d {
        val t = translation ?: doubleArrayOf(0.0, 0.0, 0.0)
        val (sx, sy, sz) = scale ?: doubleArrayOf(1.0, 1.0, 1.0)
        val (x, y, z, w) = rotation ?: doubleArrayOf(0.0, 0.0, 0.0, 1.0)

        // The columns of the quaternion's matrix, each multiplied by its scale
        return Matrix4d(
            (1.0 - 2.0 * (y * y + z * z)) * sx, 2.0 * (x * y + z * w) * sx, 2.0 * (x * z - y * w) * sx, 0.0,
            2.0 * (x * y - z * w) * sy, (1.0 - 2.0 * (x * x + z * z)) * sy, 2.0 * (y * z + x * w) * sy, 0.0,
            2.0 * (x * z + y * w) * sz, 2.0 * (y * z - x * w) * sz, (1.0 - 2.0 * (x * x + y * y)) * sz, 0.0,
            t[0], t[1], t[2], 1.0,
        )
    }

    private fun doubles(numbers: FloatArray?): DoubleArray? = numbers?.let {
        DoubleArray(it.size) { i -> it[i].toDouble() }
    }

    /** Whether [m] reverses orientation, that is, has a negative determinant. */
    fun isMirror(m: Matrix4dc): Boolean = m.m00() * (m.m11() * m.m22() - m.m12() * m.m21()) +
        m.m01() * (m.m12() * m.m20() - m.m10() * m.m22()) + m.m02() * (m.m10() * m.m21() - m.m11() * m.m20()) < 0.0

    /** Whether [m] is the identity. */
    fun isIdentity(m: Matrix4dc): Boolean = (0 until 4).all { column ->
        (0 until 4).all { row -> m.get(column, row) == if (column == row) 1.0 else 0.0 }
    }
}
