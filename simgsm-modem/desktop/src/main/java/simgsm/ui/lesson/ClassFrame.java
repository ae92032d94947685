package simgsm.ui.lesson;

import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.JFrame;
import simgsm.ui.DesktopTexts;
import simgsm.ui.SnapshotPoller;

/** The window with the results of a class. */
public final class ClassFrame {
    private ClassFrame() {}

    /** Opens the window; on the event thread. The place is in pixels of the screen. */
    public static void open(Locale language, int x, int y, int width, int height, Supplier<List<List<String>>> source) {
        ClassPanel panel = new ClassPanel(language);
        JFrame frame = new JFrame(DesktopTexts.in(language).of("class.title"));
        frame.setContentPane(panel);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.setBounds(x, y, width, height);
        frame.setVisible(true);
        new SnapshotPoller<>(source, panel::show).start();
    }
}
