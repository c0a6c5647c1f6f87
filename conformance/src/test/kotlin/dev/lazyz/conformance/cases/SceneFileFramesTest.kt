package dev.lazyz.conformance.cases

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.cutAtRow
import dev.lazyz.conformance.cases.changed.doubled
import dev.lazyz.conformance.cases.changed.inOrder
import dev.lazyz.conformance.cases.changed.keeping
import dev.lazyz.conformance.cases.changed.moved
import dev.lazyz.conformance.cases.changed.on
import dev.lazyz.conformance.cases.changed.padded
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.frames.screen.ConfettiPiece
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.screenCase
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.geometry.FillRule
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.shared.NotByDefault
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import java.util.Random
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Frames as scene files: reading them gives the same pixels, depths and primitives. */
class SceneFileFramesTest {
    @Provide
    fun cases(): Arbitrary<FrameCase> {
        val kinds = listOf(
            Frames.screen(), Frames.tied(), Frames.world(), Frames.translucent(),
            Frames.of(FrameMix.usual().with(FrameKind.CONFETTI, 0).translucent(50)),
        )
        return Arbitraries.oneOf(kinds).withoutEdgeCases()
    }

    @Property(seed = "1995", tries = 150)
    @AddLifecycleHook(NotByDefault::class)
    fun sceneFileIsTheFrame(@ForAll("cases") case: FrameCase, @ForAll salt: Long) {
        assertSame(case)

        // Also after the changes that rules make to frames
        val random = Random(salt)
        val raster = case.frame.raster
        val test = DepthTest.entries[random.nextInt(DepthTest.entries.size)]
        val other = Raster(raster.width, raster.height, raster.background, raster.convention, test, random.nextInt(9))
        val changed = listOf(
            case.on(other), case.withinAny(random), case.keeping(salt.toInt() and 1), case.doubled(),
            case.inOrder(case.frame.primitives.indices.shuffled(random)), case.glazed(random.nextInt(0x10000)),
        )
        for (it in changed) assertSame(it)
    }

    private fun assertSame(case: FrameCase) {
        val text = case.sceneFile() ?: return
        val loaded = Scenes.load(text.byteInputStream(), SceneFormat.SCENE)
        val size = checkNotNull(loaded.size)
        val frame = loaded.scene.frame(loaded.raster(size.width, size.height)).within(case.frame.region)
        assertEquals("${case.frame.raster}", "${frame.raster}")
        assertEquals(case.frame.primitives.size, frame.primitives.size)
        assertEquals(case.frame.primitives.map { it.isTranslucent }, frame.primitives.map { it.isTranslucent })
        val (expected, actual) = listOf(case.frame, frame).map(::picture)
        assertNull(difference(expected, actual)) { "${difference(expected, actual)}\n$text" }
    }

    private fun picture(frame: Frame) = Recording.of(ReferenceRenderer(), frame).image

    @Property(seed = "1995", tries = 100)
    fun polygonsOnTheScreenHaveOne(@ForAll("polygons") case: FrameCase) {
        assertNotNull(case.sceneFile())
        assertEquals(Camera.screen().projection, (case.scene?.viewpoint as Camera).projection)
    }

    @Provide
    fun polygons(): Arbitrary<FrameCase> {
        val kinds = FrameKind.entries.filter { !it.isInSpace && it != FrameKind.CONFETTI }
        return Frames.of(FrameMix.of(*kinds.toTypedArray()))
    }

    /** The default of a scene depends on its materials, of which a change may leave out some. */
    @Test
    fun toneMappingIsThatOfTheWholeScene() {
        val metal = Sphere(Vector3d(), 1.0, Material().withMetallicRoughness(MetallicRoughness()))
        val corners = listOf(Vertex(-1.0, -1.0, 0.0), Vertex(1.0, -1.0, 0.0), Vertex(0.0, 1.0, 0.0))
        val eye = Vector3d(0.0, 0.0, 4.0)
        val camera = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 0.5, 10.0)
        val scene = Scene(listOf(metal, Polygon(listOf(corners))), viewpoint = camera)
        assertSame(FrameCase(scene.frame(Raster(8, 8)), "", scene).keeping(1))
    }

    @Test
    fun whatASceneFileHasNoWordsForHasNone() {
        val raster = Raster(4, 4)
        val square = PolygonPiece(listOf(doubleArrayOf(0.0, 0.0, 0.5, 4.0, 0.0, 0.5, 4.0, 4.0, 0.5)), RULE)
        val polygons = screenCase(raster, listOf(square, square))
        assertNotNull(polygons.sceneFile())
        assertNull(screenCase(raster, listOf(square, ConfettiPiece(1, 0..4, 0..4, 2, null))).sceneFile())
        assertNull(polygons.moved(1, 1).sceneFile())
        assertNull(polygons.padded().sceneFile())
        assertNull(polygons.cutAtRow(2).sceneFile())
        assertNull(polygons.asOpaque().sceneFile())
        assertNull(FrameCase(FrameBuilder(raster).build(), "nobody knows").sceneFile())

        // Glass that covers nothing is translucent, too
        val nothing = screenCase(raster, listOf(PolygonPiece(emptyList(), RULE)))
        assertNull(nothing.glazed(1).sceneFile())
        assertTrue((polygons.glazed(2).scene?.surfaces?.get(1) as Polygon).material.isTranslucent)
    }

    private companion object {
        val RULE = FillRule.NON_ZERO
    }
}
