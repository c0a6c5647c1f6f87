package dev.lazyz.scenes

/**
 * A file that cannot be understood: the one exception that every reader of this module throws for bad input.
 *
 * The message is complete and made for the person who has the file: where, what is wrong, what to do. It may be shown on a
 * terminal: it has no control characters, and words of a file's are cut after 400 characters. The properties may have both.
 *
 * @property source the file's name as the caller gave it, or a name for a stream
 * @property location place within the file, such as `line 12`, `byte 84` or `meshes[2].material`; null if it is all of it
 * @property problem what is wrong, without a full stop
 * @property remedy what to do about it, or null if there is nothing but to get another file
 */
public class SceneFormatException @JvmOverloads constructor(
    public val source: String,
    public val location: String?,
    public val problem: String,
    public val remedy: String? = null,
    cause: Throwable? = null,
) : RuntimeException(
    printable(
        buildString {
            append(source)
            if (location != null) append(", ").append(location)
            append(": ").append(problem)
            if (remedy != null) append("; ").append(remedy)
        },
    ),
    cause,
)
