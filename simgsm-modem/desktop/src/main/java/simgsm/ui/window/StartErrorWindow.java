package simgsm.ui.window;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.console.Arguments;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.ReadingArea;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** A window with the reason why a program could not start, for a start without a terminal. */
public final class StartErrorWindow {
    private static final int COLUMNS = 44;
    private static final int ROWS = 4;

    private StartErrorWindow() {}

    /**
     * Returns when the user has closed the window, or the program that started this one has ended; at once without a
     * display.
     */
    public static void show(String program, String text, Optional<Arguments> arguments) {
        if (!Display.isAvailable()) {
            return;
        }
        TextBundle texts = DesktopTexts.in(language(arguments));
        CountDownLatch closed = new CountDownLatch(1);
        SwingUtilities.invokeLater(() -> open(program, text, texts, closed));
        if (arguments.isPresent() && arguments.get().has("end-with-input")) {
            EndOfInput.then(closed::countDown);
        }
        try {
            closed.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static Locale language(Optional<Arguments> arguments) {
        try {
            return arguments.isPresent() ? arguments.get().language() : Locale.getDefault();
        } catch (UsageException e) {
            return Locale.getDefault();
        }
    }

    private static void open(String program, String text, TextBundle texts, CountDownLatch closed) {
        Theme.install(Appearance.LIGHT);
        JFrame frame = new JFrame(texts.of("window.failed.title", program));
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                closed.countDown();
            }
        });
        frame.setContentPane(content(program, text, texts, frame::dispose));
        frame.pack();
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
    }

    /** The window's content: the program, the error's text, which can be copied, and a button. */
    static JPanel content(String program, String text, TextBundle texts, Runnable close) {
        String title = texts.of("window.failed.title", program);
        JTextArea words = new ReadingArea(text);
        words.setRows(ROWS);
        words.setColumns(COLUMNS);
        words.setFont(Theme.base());
        words.setOpaque(false);
        UserAction action = new UserAction("failed.close", texts.of("window.failed.close"), close);
        JButton button = new JButton(action);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        buttons.setOpaque(false);
        buttons.add(ComponentNames.name(button, action.id(), action.name()));
        JPanel content = new JPanel(new BorderLayout());
        content.setBorder(Theme.padding(16));
        content.setBackground(Theme.color(Ink.SURFACE));
        content.add(Arrange.column(
                Theme.GRID,
                Theme.label(title, Theme::title, Ink.DANGER),
                Arrange.growing(ComponentNames.name(words, "failed.text", title)),
                buttons));
        action.bind(
                content,
                JComponent.WHEN_IN_FOCUSED_WINDOW,
                KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0));
        return content;
    }
}
