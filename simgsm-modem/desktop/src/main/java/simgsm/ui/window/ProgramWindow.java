package simgsm.ui.window;

import java.awt.Dimension;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import simgsm.console.Arguments;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.draw.Appearance;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;

/**
 * A program's one window: reads the options that every window has, opens a frame around what the program shows, and waits
 * for its end. The frame stays thin; all that can be seen is the program's own panel.
 */
public final class ProgramWindow {
    /**
     * What a program puts into its window, made on the event thread.
     *
     * @param size at first, unless {@code --window} says otherwise; empty for as large as the panel likes
     * @param shown run once the window is on the screen
     * @param closed run once it is gone
     */
    public record Content(
            String title,
            List<Image> icons,
            JComponent panel,
            Optional<Dimension> size,
            Optional<Dimension> least,
            Runnable shown,
            Runnable closed) {}

    private static final int HUNDRED_PERCENT = 100;

    private final Appearance appearance;
    private final double zoom;
    private final Optional<WindowPlace> place;
    private final Locale language;
    private final boolean endsWithInput;
    private final CountDownLatch ended = new CountDownLatch(1);

    private ProgramWindow(
            Appearance appearance, double zoom, Optional<WindowPlace> place, Locale language, boolean endsWithInput) {
        this.appearance = appearance;
        this.zoom = zoom;
        this.place = place;
        this.language = language;
        this.endsWithInput = endsWithInput;
    }

    /**
     * Reads {@code --theme}, {@code --zoom}, {@code --window}, {@code --lang} and {@code --end-with-input}; nothing is
     * opened yet.
     *
     * @param otherwise where the window goes if the command line does not say; empty for wherever the desktop likes
     * @throws UnavailableException without a display
     */
    public static ProgramWindow of(Arguments arguments, Optional<WindowPlace> otherwise)
            throws UsageException, UnavailableException {
        Optional<Appearance> chosen = arguments.value("theme", ProgramWindow::appearance);
        Optional<WindowPlace> place = arguments.value("window", WindowPlace::parse);
        double zoom = percent(arguments) / (double) HUNDRED_PERCENT;
        Locale language = arguments.language();
        if (!Display.isThere()) {
            throw new UnavailableException(DesktopTexts.in(language).of("window.noDisplay"));
        }
        return new ProgramWindow(
                chosen.orElseGet(ProgramWindow::systemAppearance),
                zoom,
                place.or(() -> otherwise),
                language,
                arguments.has("end-with-input"));
    }

    private static Appearance appearance(String text) {
        return text.equalsIgnoreCase("system") ? systemAppearance() : Appearance.parse(text);
    }

    /** The desktop's appearance by its GTK theme's name; light where there is none. */
    private static Appearance systemAppearance() {
        Object name = System.getenv("GTK_THEME");
        if (name == null && Display.isThere()) {
            name = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
        }
        String lower = String.valueOf(name).toLowerCase(Locale.ROOT);
        return lower.endsWith("dark") || lower.endsWith("-inverse") ? Appearance.DARK : Appearance.LIGHT;
    }

    private static int percent(Arguments arguments) throws UsageException {
        return (int) arguments.integer("zoom", HUNDRED_PERCENT, (int) (Theme.ZOOM_MIN * HUNDRED_PERCENT), (int)
                (Theme.ZOOM_MAX * HUNDRED_PERCENT));
    }

    /** The same window at another size of everything, unless the command line has said which. */
    public ProgramWindow zoomed(Arguments arguments, int percent) {
        return arguments.has("zoom")
                ? this
                : new ProgramWindow(appearance, percent / (double) HUNDRED_PERCENT, place, language, endsWithInput);
    }

    /** Opens the window and returns when it has been closed, by its user or by {@link #close}. */
    public void show(Supplier<Content> content) throws InterruptedException {
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance);
            Theme.zoomTo(zoom);
            open(content.get());
        });
        if (endsWithInput) {
            endWithInput();
        }
        ended.await();
    }

    /** Ends {@link #show}; any thread may ask. */
    public void close() {
        ended.countDown();
    }

    private void open(Content content) {
        JFrame frame = new JFrame(content.title());
        frame.setIconImages(content.icons());
        frame.setContentPane(content.panel());
        WindowKeys.install(frame.getRootPane(), language);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                content.closed().run();
                close();
            }
        });
        content.least().ifPresent(least -> frame.setMinimumSize(zoomed(least)));
        lay(frame, content);
        frame.setVisible(true);
        content.shown().run();
    }

    private void lay(JFrame frame, Content content) {
        frame.pack();
        content.size().map(this::zoomed).ifPresent(size -> {
            Rectangle screen = frame.getGraphicsConfiguration().getBounds();
            frame.setSize(Math.min(size.width, screen.width), Math.min(size.height, screen.height));
        });
        place.ifPresentOrElse(where -> where.take(frame), () -> frame.setLocationByPlatform(true));
    }

    private Dimension zoomed(Dimension size) {
        return new Dimension((int) Math.round(size.width * zoom), (int) Math.round(size.height * zoom));
    }

    /** Whoever started the program holds its input open; when that ends, the program ends. */
    private void endWithInput() {
        Thread reader = new Thread(
                () -> {
                    try {
                        System.in.transferTo(OutputStream.nullOutputStream());
                    } catch (IOException e) {
                        // An input that breaks has ended, too.
                    }
                    close();
                },
                "end of input");
        reader.setDaemon(true);
        reader.start();
    }
}
