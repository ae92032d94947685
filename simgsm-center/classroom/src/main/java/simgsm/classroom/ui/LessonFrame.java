package simgsm.classroom.ui;

import java.awt.Image;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.window.WindowKeys;

/** The window of a lesson. */
public final class LessonFrame {
    private final JFrame frame;
    private final SnapshotPoller<LessonView> newest;

    private LessonFrame(JFrame frame, SnapshotPoller<LessonView> newest) {
        this.frame = frame;
        this.newest = newest;
    }

    /** Opens the window; on the event thread. The place is in pixels of the screen. */
    public static LessonFrame open(
            String title,
            List<Image> icons,
            LessonPanel panel,
            int x,
            int y,
            int width,
            int height,
            Supplier<LessonView> source) {
        JFrame frame = new JFrame(title);
        frame.setIconImages(icons);
        frame.setContentPane(panel);
        WindowKeys.installBeside(frame.getRootPane(), panel.getLocale());
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.setBounds(x, y, width, height);
        frame.setVisible(true);
        panel.focusFirst();
        SnapshotPoller<LessonView> newest = new SnapshotPoller<>(source, panel::show);
        newest.start();
        return new LessonFrame(frame, newest);
    }

    /** Closes the window; callable on any thread. */
    public void close() {
        SwingUtilities.invokeLater(() -> {
            newest.stop();
            frame.dispose();
        });
    }
}
