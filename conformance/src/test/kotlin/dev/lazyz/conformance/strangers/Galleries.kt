package dev.lazyz.conformance.strangers

import dev.lazyz.Renderer
import dev.lazyz.conformance.strangers2.SecondGallery
import dev.lazyz.conformance.strangers3.ThirdGallery
import dev.lazyz.conformance.strangers4.FourthGallery
import dev.lazyz.conformance.strangers5.FifthGallery

/** All galleries of strangers, in the order in which they were written. */
internal object Galleries {
    val byName: Map<String, List<Stranger>> = linkedMapOf(
        "first" to StrangersGallery.all,
        "second" to SecondGallery.all,
        "third" to ThirdGallery.all,
        "fourth" to FourthGallery.all,
        "fifth" to FifthGallery.all,
    )

    /** The right renderers that the wrong ones derive from. */
    val correct: List<() -> Renderer> =
        StrangersGallery.correct + SecondGallery.correct + ThirdGallery.correct + FourthGallery.correct +
            FifthGallery.correct
}
