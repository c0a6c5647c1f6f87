package example;

import dev.lazyz.lighting.LightRig;
import dev.lazyz.scenes.pictures.PictureParameters;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.swing.ModelView;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

/** A model in a window: dragging turns it, and a click tells the name of the part under the mouse. */
public final class ModelWindow {
    private ModelWindow() {}

    static ModelView view(Path file, Consumer<String> clicked) {
        ModelView view = new ModelView();
        view.setSettings(new PictureSettings().with(PictureParameters.LIGHT, LightRig.SUN));
        view.setOnPick(point -> clicked.accept(point == null ? "" : point.getSeen().getPart()));
        view.open(file);
        return view;
    }

    public static void main(String[] args) {
        SwingUtilities.invokeLater(() -> {
            JFrame window = new JFrame(args[0]);
            window.add(view(Path.of(args[0]), window::setTitle));
            window.pack();
            window.setDefaultCloseOperation(WindowConstants.EXIT_ON_CLOSE);
            window.setVisible(true);
        });
    }
}
