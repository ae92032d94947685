package simgsm.ui.lesson;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import simgsm.ui.DesktopTexts;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.UserAction;
import simgsm.ui.window.WindowIcon;
import simgsm.ui.window.WindowKeys;

/** The window of a class. */
public final class ClassFrame {
    private ClassFrame() {}

    /** Opens the window, which is closed with the program's other windows only; on the event thread. The place is in pixels of the screen. */
    public static void open(
            Locale language, int x, int y, int width, int height, ClassActs acts, Supplier<ClassView> source) {
        ClassPanel panel = new ClassPanel(language, acts);
        JFrame frame = new JFrame(DesktopTexts.in(language).of("class.title"));
        frame.setContentPane(panel);
        // The results last as long as the class: there is no other way back to them.
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                frame.setExtendedState(JFrame.ICONIFIED);
            }
        });
        frame.setBounds(x, y, width, height);
        frame.setIconImages(WindowIcon.images(Symbol.PERSON));
        WindowKeys.install(frame.getRootPane(), language);
        frame.setVisible(true);
        new SnapshotPoller<>(source, panel::show).start();
    }

    /** Fills the screen with a content; Escape closes it. */
    static void openLarge(Component beside, String title, JComponent content) {
        JFrame frame = new JFrame(title, beside.getGraphicsConfiguration());
        frame.setContentPane(content);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        new UserAction("class.large.close", title, frame::dispose)
                .bindInWindow(frame.getRootPane(), KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
        frame.setIconImages(WindowIcon.images(Symbol.PERSON));
        frame.setBounds(beside.getGraphicsConfiguration().getBounds());
        frame.setExtendedState(JFrame.MAXIMIZED_BOTH);
        frame.setVisible(true);
    }
}
