package dev.lazyz.conformance.results

import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException

/** Returns [number] and what it counts, [thing], in the plural unless the number is 1. */
internal fun counted(number: Long, thing: String): String = if (number == 1L) "1 $thing" else "$number ${thing}s"

/** Returns why a file or a folder cannot be used, for a message that names it. */
internal fun reason(failure: IOException): String = when (failure) {
    is NoSuchFileException -> "there is no such file"
    is AccessDeniedException -> "permission denied"
    is NotDirectoryException, is FileAlreadyExistsException -> "it is not a folder"
    is CharacterCodingException -> "it is not text in UTF-8"
    is FileSystemException -> failure.reason ?: failure.javaClass.simpleName
    else -> failure.message ?: failure.javaClass.simpleName
}
