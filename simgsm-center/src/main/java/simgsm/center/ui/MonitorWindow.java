package simgsm.center.ui;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.ui.Appearance;
import simgsm.ui.Newest;
import simgsm.ui.Symbol;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simgsm.ui.WindowIcon;
import simgsm.ui.WindowKeys;
import simgsm.ui.WindowPlace;

/** The centre's window: a frame around {@link MonitorPanel}. */
public final class MonitorWindow {
    private MonitorWindow() {}

    /**
     * Opens the window; returns at once.
     *
     * @param place where it goes; empty for wherever the desktop likes
     */
    public static void open(
            Operator operator, Texts texts, Locale language, Appearance appearance, Optional<WindowPlace> place) {
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance);
            show(new MonitorPanel(texts, operator), operator, texts, language, place);
        });
    }

    private static void show(
            MonitorPanel panel, Operator operator, Texts texts, Locale language, Optional<WindowPlace> place) {
        JFrame frame = new JFrame(texts.of("window.title"));
        frame.setIconImages(WindowIcon.images(Symbol.BROADCAST));
        frame.setContentPane(panel);
        WindowKeys.install(frame.getRootPane(), language);
        Newest<ExchangeSnapshot> newest = new Newest<>(() -> operator.snapshot().orElse(null), snapshot -> {
            if (snapshot != null) {
                panel.show(snapshot);
            }
        });
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                newest.stop();
                operator.quit();
            }
        });
        frame.pack();
        place.ifPresentOrElse(where -> where.take(frame), () -> frame.setLocationByPlatform(true));
        newest.start();
        frame.setVisible(true);
        panel.requestFocusInWindow();
    }
}
