@file:JvmName("GoldenAssertions")

package dev.lazyz.testing

import dev.lazyz.Image
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.world.Scene

/**
 * Begins a golden test of [scene], which is rendered at the size that follows.
 *
 * Kotlin: `assertThat(scene).at(512, 512).matches("golden/teapot.png")`; Java: the same, with
 * `import static dev.lazyz.testing.GoldenAssertions.assertThat`.
 */
public fun assertThat(scene: Scene): SceneAssertion = SceneAssertion(scene, Goldens.current())

/** Begins a golden test of the colours of [image]. Its depths and primitives are not compared. */
public fun assertThat(image: Image): PictureAssertion =
    PictureAssertion(Goldens.current()) { ActualPicture(Picture.of(image)) { image.toPng() } }

/** Begins a golden test of a picture in memory: [png] are the bytes of a PNG file. */
public fun assertThat(png: ByteArray): PictureAssertion =
    PictureAssertion(Goldens.current()) { ActualPicture(Picture.decode(png)) { png } }
