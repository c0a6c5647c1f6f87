package dev.lazyz.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.scenes.aov.AovFiles;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.html.Html;
import dev.lazyz.scenes.pictures.Picture;
import dev.lazyz.scenes.scenefile.SceneFile;
import dev.lazyz.scenes.writers.ImageFiles;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.scenes.writers.PfmSink;
import dev.lazyz.scenes.writers.PngSink;
import dev.lazyz.scenes.writers.PpmSink;
import dev.lazyz.scenes.writers.animation.AnimationFiles;
import dev.lazyz.scenes.writers.animation.ApngSink;
import dev.lazyz.scenes.writers.animation.GifSink;
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles;
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink;
import java.io.IOException;
import java.lang.reflect.Executable;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Java catches a checked exception only where a method declares it. */
class JavaExceptionsTest {
    /** Every public method of the type that has one of the names, and with "new" its constructors. */
    private static void declare(Class<? extends Exception> exception, Class<?> type, String... names) {
        for (String name : names) {
            Stream<? extends Executable> all = name.equals("new")
                    ? Arrays.stream(type.getConstructors())
                    : Arrays.stream(type.getMethods())
                            .filter(method -> method.getName().equals(name));
            List<? extends Executable> found =
                    all.filter(one -> !one.isSynthetic()).toList();
            assertFalse(found.isEmpty(), type + " " + name);
            for (Executable one : found) {
                assertTrue(List.of(one.getExceptionTypes()).contains(exception), "" + one);
            }
        }
    }

    @Test
    void whatWritesDeclaresThatItFails() {
        declare(IOException.class, Images.class, "writePng", "writePpm", "writePfm", "sendTo");
        declare(IOException.class, ImageFiles.class, "write");
        declare(IOException.class, AnimationFiles.class, "write");
        declare(IOException.class, DeepZoomFiles.class, "write", "resume", "publish", "tiles");
        declare(IOException.class, SceneFile.class, "write");
        declare(IOException.class, AovFiles.class, "write");
        declare(IOException.class, Html.class, "write");
        for (Class<?> sink : List.of(PngSink.class, PpmSink.class, PfmSink.class, ApngSink.class, DeepZoomSink.class)) {
            declare(IOException.class, sink, "new", "row", "close");
        }
        declare(IOException.class, GifSink.class, "close");
    }

    @Test
    void whatReadsDeclaresThatAFileIsWrong() {
        declare(SceneFormatException.class, Scenes.class, "load", "stream", "texture");
        declare(SceneFormatException.class, Picture.class, "read", "decode");
    }

    @Test
    void whatRendersDeclaresThatItIsInterrupted() {
        declare(InterruptedException.class, ImageFiles.class, "write");
        declare(InterruptedException.class, AnimationFiles.class, "write");
        declare(InterruptedException.class, DeepZoomFiles.class, "write", "resume");
    }

    /** The file that is written is not what is wrong. */
    @Test
    void aModelThatIsDrawnIntoAFileIsNamed(@TempDir Path folder) {
        Path model = folder.resolve("missing/a.obj");
        IOException e = assertThrows(
                IOException.class, () -> ImageFiles.write(folder.resolve("a.png"), 2, 2, sink -> Scenes.load(model)));
        assertEquals(model + ": there is no such file; check the name", e.getMessage());
    }
}
