package simgsm.ui.window;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.console.Arguments;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.draw.Appearance;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** A program's window: reads the options of windows, opens a frame around the program's panel, and waits for its end. */
public final class ProgramWindow {
    private static final System.Logger LOG = System.getLogger(ProgramWindow.class.getName());

    /**
     * The content of a window, made on the event thread.
     *
     * @param help what the window is for, shown by F1 above its keys
     * @param symbol of the window's icon
     * @param size at first, unless {@code --window} gives another; empty for the panel's preferred size
     * @param closing called when the user closes the window, with the action that does it; asks about what is unsaved
     * @param shown run when the window is on the screen
     * @param closed run when the window has been closed
     */
    public record Content(
            String title,
            String help,
            Symbol symbol,
            JComponent panel,
            Optional<Dimension> size,
            Optional<Dimension> least,
            Consumer<Runnable> closing,
            Runnable shown,
            Runnable closed) {}

    private static final int HUNDRED_PERCENT = 100;

    private final Appearance appearance;
    private final double zoom;
    private final Optional<WindowPlace> place;
    private final Locale language;
    private final boolean endsWithInput;
    private final CountDownLatch ended = new CountDownLatch(1);
    private Optional<Consumer<String>> lessonChosen = Optional.empty();

    private ProgramWindow(
            Appearance appearance, double zoom, Optional<WindowPlace> place, Locale language, boolean endsWithInput) {
        this.appearance = appearance;
        this.zoom = zoom;
        this.place = place;
        this.language = language;
        this.endsWithInput = endsWithInput;
    }

    /**
     * Reads {@code --theme}, {@code --zoom}, {@code --window}, {@code --lang} and {@code --end-with-input}; opens
     * nothing.
     *
     * @param otherwise the place without {@code --window}; empty for the desktop's choice
     * @throws UnavailableException without a display
     */
    public static ProgramWindow of(Arguments arguments, Optional<WindowPlace> otherwise)
            throws UsageException, UnavailableException {
        Optional<Appearance> chosen = arguments.value("theme", ProgramWindow::appearance);
        Optional<WindowPlace> place = arguments.value("window", WindowPlace::parse);
        double zoom = zoomPercent(arguments).orElse(HUNDRED_PERCENT) / (double) HUNDRED_PERCENT;
        Locale language = arguments.language();
        if (!Display.isAvailable()) {
            throw new UnavailableException(DesktopTexts.in(language).of("window.noDisplay"));
        }
        return new ProgramWindow(
                chosen.orElseGet(ProgramWindow::systemAppearance),
                zoom,
                place.or(() -> otherwise),
                language,
                arguments.has("end-with-input") && !arguments.has("console"));
    }

    private static Appearance appearance(String text) {
        return text.equalsIgnoreCase("system") ? systemAppearance() : Appearance.parse(text);
    }

    /** The desktop's appearance by its GTK theme's name; light where there is none. */
    private static Appearance systemAppearance() {
        Object name = System.getenv("GTK_THEME");
        if (name == null && Display.isAvailable()) {
            name = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
        }
        String lower = String.valueOf(name).toLowerCase(Locale.ROOT);
        return lower.endsWith("dark") || lower.endsWith("-inverse") ? Appearance.DARK : Appearance.LIGHT;
    }

    /** The value of {@code --zoom}; empty without it. */
    public static OptionalInt zoomPercent(Arguments arguments) throws UsageException {
        return arguments.has("zoom")
                ? OptionalInt.of(
                        (int) arguments.integer("zoom", HUNDRED_PERCENT, (int) (Theme.ZOOM_MIN * HUNDRED_PERCENT), (int)
                                (Theme.ZOOM_MAX * HUNDRED_PERCENT)))
                : OptionalInt.empty();
    }

    /** The same window at another zoom. */
    public ProgramWindow zoomed(int percent) {
        return new ProgramWindow(appearance, percent / (double) HUNDRED_PERCENT, place, language, endsWithInput);
    }

    /** Opens the window and returns when its user or {@link #close} has closed it. */
    public void show(Supplier<Content> content) throws InterruptedException {
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance, zoom);
            open(content.get());
        });
        if (endsWithInput) {
            EndOfInput.then(this::close);
        }
        ended.await();
        // The end of the process may take a second or two.
        SwingUtilities.invokeLater(() -> Stream.of(Window.getWindows()).forEach(Window::dispose));
    }

    /** What happens when the user begins a lesson in the help; without it the help says how to begin one. */
    public void onLesson(Consumer<String> chosen) {
        lessonChosen = Optional.of(chosen);
    }

    /** A console beside the window: its end closes the window. */
    public interface ConsoleRun {
        void run() throws Exception;
    }

    /** Runs a console on a thread of its own, for {@code --console}; to be called before {@link #show}. */
    public void withConsole(ConsoleRun console) {
        Thread thread = new Thread(
                () -> {
                    try {
                        console.run();
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    } catch (Exception e) {
                        LOG.log(System.Logger.Level.WARNING, "the console has ended: {0}", Program.describe(e));
                    }
                    close();
                },
                "console");
        thread.setDaemon(true);
        thread.start();
    }

    /** Ends {@link #show}; any thread. */
    public void close() {
        ended.countDown();
    }

    private void open(Content content) {
        JFrame frame = new JFrame(content.title());
        frame.setContentPane(content.panel());
        WindowKeys.install(frame.getRootPane(), language);
        TextBundle texts = DesktopTexts.in(language);
        String version = Program.version(content.panel().getClass());
        new UserAction(
                        "window.help",
                        texts.of("window.help"),
                        () -> HelpDialog.open(frame, content.help(), version, language, lessonChosen))
                .bindInWindow(frame.getRootPane(), KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                content.closing().accept(frame::dispose);
            }

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
        // The icon is painted once the window is there.
        SwingUtilities.invokeLater(() -> frame.setIconImages(WindowIcon.images(content.symbol())));
    }

    private void lay(JFrame frame, Content content) {
        frame.pack();
        content.size().map(this::zoomed).ifPresent(size -> {
            Rectangle screen = frame.getGraphicsConfiguration().getBounds();
            frame.setSize(Math.min(size.width, screen.width), Math.min(size.height, screen.height));
        });
        place.ifPresentOrElse(where -> where.applyTo(frame), () -> frame.setLocationByPlatform(true));
    }

    private Dimension zoomed(Dimension size) {
        return new Dimension((int) Math.round(size.width * zoom), (int) Math.round(size.height * zoom));
    }
}
