@file:JvmName("PictureAssertions")

package dev.lazyz.conformance

import dev.lazyz.Image
import dev.lazyz.conformance.judgement.differenceInWords

/**
 * Fails unless [actual] is the same picture as [expected], as defined by contract rule 7.1: the same region, and at
 * every sample the same colour, depth and primitive, without tolerance. Counters are not compared. Cost: one pass over
 * the samples.
 *
 * Kotlin: `assertSamePicture(expected, actual)`; Java: `PictureAssertions.assertSamePicture(expected, actual)`.
 *
 * @param code code that creates the frame, to be appended to the message; ignored if empty
 * @throws AssertionError if the pictures differ; the message has the first sample that differs, in rows from the top,
 *   with both values, and the number of samples that differ; or both regions, if those differ
 */
@JvmOverloads
public fun assertSamePicture(expected: Image, actual: Image, code: String = "") {
    val words = differenceInWords(expected, actual) ?: return
    throw AssertionError("the pictures differ: $words" + if (code.isEmpty()) "" else "\nin\n$code")
}
