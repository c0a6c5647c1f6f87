package dev.lazyz.conformance.strangers


/** Promises that are not kept, and options that change what they must not. */
internal val promiseMistakes: List<Stranger> = listOf(
)
