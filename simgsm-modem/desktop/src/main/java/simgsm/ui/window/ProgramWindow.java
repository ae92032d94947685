package simgsm.ui.window;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.Program;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.draw.Appearance;
import simgsm.lesson.LessonLibrary;
import simgsm.thread.DaemonThread;
import simgsm.ui.CommandGroup;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.file.LastFolder;

/** A program's window: reads the options of windows, opens a frame around the program's panel, and waits for its end. */
public final class ProgramWindow {
    private static final System.Logger LOG = System.getLogger(ProgramWindow.class.getName());

    /**
     * The content of a window, made on the event thread.
     *
     * @param help purpose of the window, shown by F1 above its keys
     * @param symbol of the window's icon
     * @param size without {@code --window}; empty for the panel's preferred size
     * @param closing called when the user closes the window, with the action that closes it; asks about unsaved work
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

    /** Key of the last chosen file's folder in the window's memory. */
    private static final String FOLDER = "folder";

    private static final int HUNDRED_PERCENT = 100;
    private static final int SHARING_MILLIS = 1000;

    private final Appearance appearance;
    private final double zoom;
    private final Optional<WindowPlace> place;
    private final boolean endsWithInput;
    private final boolean takesFocus;
    private final LessonLibrary lessons;
    private final Optional<WindowMemory> memory;
    private final String rememberedAs;
    private final CountDownLatch ended = new CountDownLatch(1);
    private Optional<Consumer<String>> lessonChosen = Optional.empty();
    private boolean hasSheets;
    private String lessonQuestion = "lessons.ends";

    // on the event thread, once the window is open
    private SharedSettings shared;
    private Timer sharing;
    private Locale language;
    private JFrame frame;
    private Content content;
    /** Makes the content in another language; empty if the program has its own setting. */
    private Optional<Function<Locale, Content>> contents = Optional.empty();

    private ProgramWindow(Appearance appearance, double zoom, Optional<WindowPlace> place, Arguments arguments)
            throws UsageException {
        this.appearance = appearance;
        this.zoom = zoom;
        this.place = place;
        this.language = arguments.language();
        this.endsWithInput = arguments.has("end-with-input") && !arguments.has("console");
        this.takesFocus = !arguments.has("unfocused");
        this.lessons = LessonLibrary.of(arguments);
        this.memory = WindowMemory.of(arguments);
        this.rememberedAs = memory.isPresent() ? WindowMemory.nameOf(arguments) : "";
    }

    /**
     * Reads {@code --theme}, {@code --zoom}, {@code --window}, {@code --lang}, {@code --lessons} and {@code
     * --end-with-input}; opens nothing.
     *
     * @param otherwise place without {@code --window}; empty for the desktop's choice
     * @throws UnavailableException without a display
     */
    public static ProgramWindow of(Arguments arguments, Optional<WindowPlace> otherwise)
            throws UsageException, UnavailableException {
        Optional<Appearance> chosen = arguments.value("theme", WindowOptions::appearance);
        Optional<WindowPlace> place = arguments.value("window", WindowPlace::parse);
        double zoom = WindowOptions.zoomPercent(arguments).orElse(HUNDRED_PERCENT) / (double) HUNDRED_PERCENT;
        Locale language = arguments.language();
        if (!Display.isAvailable()) {
            throw new UnavailableException(DesktopTexts.in(language).of("window.noDisplay"));
        }
        return new ProgramWindow(
                chosen.orElseGet(WindowOptions::systemAppearance), zoom, place.or(() -> otherwise), arguments);
    }

    /** Opens the window and returns after its user or {@link #close} has closed it. */
    public void show(Supplier<Content> made) throws InterruptedException {
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance, zoom);
            open(made.get());
            memory.ifPresent(this::share);
        });
        if (endsWithInput) {
            EndOfInput.then(this::close);
        }
        ended.await();
        // The process may need 1 or 2 s to end.
        SwingUtilities.invokeLater(() -> {
            keep();
            if (sharing != null) {
                sharing.stop();
            }
            Stream.of(Window.getWindows()).forEach(Window::dispose);
        });
    }

    /** As above, with a content that is made again for another language. */
    public void show(Function<Locale, Content> made) throws InterruptedException {
        contents = Optional.of(made);
        show(() -> made.apply(language));
    }

    /** Sets the action that begins a lesson from the help; without it the help says how to begin one. */
    public void onLesson(Consumer<String> chosen) {
        lessonChosen = Optional.of(chosen);
        lessonQuestion = "lessons.ends";
    }

    /** Shows the teacher's sheets in the help: in the centre's window alone, as pupils have the others. */
    public void showSheets() {
        hasSheets = true;
    }

    /** As {@link #onLesson}, for a program that goes on beside the lesson. */
    public void onLessonBeside(Consumer<String> chosen) {
        onLesson(chosen);
        lessonQuestion = "lessons.beside";
    }

    /**
     * Runs a console on its own thread, for {@code --console}; call before {@link #show}. Its end closes the window. With
     * {@code --end-with-input}, the program that started this one reads there which lesson the user has chosen.
     */
    public void withConsole(Console console, Arguments arguments, Console.Commands commands) {
        if (arguments.has("end-with-input")) {
            onLesson(name -> console.emit(Event.of("lesson").with("name", name)));
        }
        DaemonThread.start("console", () -> {
            try {
                Program.runConsole(console, arguments, commands);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            } catch (Exception e) {
                LOG.log(System.Logger.Level.WARNING, "the console has ended: {0}", Program.describe(e));
            }
            close();
        });
    }

    /** Ends {@link #show}; any thread. */
    public void close() {
        ended.countDown();
    }

    private void open(Content first) {
        content = first;
        JComponent.setDefaultLocale(language);
        memory.flatMap(kept -> kept.list(FOLDER).stream().findFirst())
                .map(Path::of)
                .ifPresent(LastFolder::set);
        frame = new JFrame();
        fill();
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                content.closing().accept(() -> {
                    keep();
                    frame.dispose();
                });
            }

            @Override
            public void windowClosed(WindowEvent event) {
                content.closed().run();
                close();
            }
        });
        content.least().ifPresent(least -> frame.setMinimumSize(zoomed(least)));
        lay();
        frame.setContentPane(new StartingLabel(content.title(), language, this::showPanel));
        frame.setAutoRequestFocus(takesFocus);
        frame.setVisible(true);
        frame.setAutoRequestFocus(true);
    }

    /** Replaces the label of a starting window by the program's panel. */
    private void showPanel() {
        frame.setContentPane(content.panel());
        frame.validate();
        frame.repaint();
        content.shown().run();
        // Painted after the panel.
        SwingUtilities.invokeLater(() -> frame.setIconImages(WindowIcon.images(content.symbol())));
    }

    private void fill() {
        frame.setTitle(content.title());
        frame.setContentPane(content.panel());
        WindowKeys.install(frame.getRootPane(), language);
        KeyStroke f11 = KeyStroke.getKeyStroke(KeyEvent.VK_F11, 0);
        if (WindowCommands.of(content.panel()).stream()
                .noneMatch(command -> command.keys().contains(f11))) {
            new UserAction("window.full", DesktopTexts.in(language).of("window.full"), this::fillScreen)
                    .in(CommandGroup.WINDOW)
                    .bindInWindow(frame.getRootPane(), f11);
        }
        helpCommand("window.help", KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
        Stream.of("lessons.title", "glossary.title", "settings.title", "about.title")
                .forEach(this::helpCommand);
    }

    /** Fills the screen or gives it back, in windows whose content has no view of its own for that. */
    private void fillScreen() {
        Display.maximize(content.panel(), frame.getExtendedState() == JFrame.NORMAL);
    }

    /** @param tab key of the text of a tab of the help */
    private void helpCommand(String tab, KeyStroke... keys) {
        new UserAction(tab, DesktopTexts.in(language).of(tab), () -> help(tab))
                .in(CommandGroup.WINDOW)
                .bindInWindow(frame.getRootPane(), keys);
    }

    /** @param tab text key of the tab shown first */
    private void help(String tab) {
        Consumer<Locale> speakAndStay = next -> {
            speak(next);
            help("settings.title");
        };
        Optional<Consumer<Locale>> speak = contents.isPresent() ? Optional.of(speakAndStay) : Optional.empty();
        HelpDialog.open(
                frame,
                content.help(),
                Program.version(content.panel().getClass()),
                language,
                new HelpDialog.Lessons(lessons, hasSheets, lessonChosen, lessonQuestion),
                new SettingsPanel.Actions(speak, this::dress, this::zoomTo, memory),
                tab);
    }

    /** Shows another language's content, unless the user wants to keep unsaved work. Called on the event thread. */
    public void speak(Locale next) {
        if (next.getLanguage().equals(language.getLanguage())) {
            return;
        }
        content.closing().accept(() -> {
            content.closed().run();
            language = next;
            JComponent.setDefaultLocale(next);
            content = contents.orElseThrow().apply(next);
            fill();
            frame.validate();
            frame.repaint();
            content.shown().run();
        });
    }

    private void share(WindowMemory kept) {
        shared = new SharedSettings(kept, this::settings, this::adopt);
        sharing = new Timer(SHARING_MILLIS, event -> shared.look());
        sharing.start();
    }

    private Map<String, String> settings() {
        String theme = Theme.appearance().word();
        return contents.isPresent() ? Map.of("theme", theme, "lang", language.getLanguage()) : Map.of("theme", theme);
    }

    private void adopt(Map<String, String> changed) {
        Optional.ofNullable(changed.get("theme")).map(Appearance::parse).ifPresent(this::dress);
        if (contents.isPresent() && changed.containsKey("lang")) {
            speak(Locale.forLanguageTag(changed.get("lang")));
        }
    }

    private void dress(Appearance next) {
        Theme.install(next);
        Stream.of(Window.getWindows()).forEach(Theme::refresh);
    }

    private void zoomTo(int percent) {
        WindowKeys.zoomTo(frame.getRootPane(), percent / (double) HUNDRED_PERCENT);
    }

    /** Keeps place and zoom, and changes of theme and language. */
    private void keep() {
        memory.ifPresent(kept ->
                LastFolder.get().ifPresent(folder -> kept.keepList(FOLDER, List.of(folder.toString()))));
        if (memory.isEmpty() || frame == null || !frame.isShowing()) {
            return;
        }
        if (frame.getExtendedState() == JFrame.NORMAL) {
            Rectangle at = frame.getBounds();
            memory.get()
                    .keep(
                            rememberedAs,
                            new WindowPlace(at.x, at.y, at.width, at.height),
                            (int) Math.round(Theme.zoom() * HUNDRED_PERCENT),
                            Display.screens());
        }
        shared.tell();
    }

    private void lay() {
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
