package simgsm.phone;

import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Clock;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.phone.handset.HandsetListener;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.ui.HandsetPanel;
import simgsm.station.StationIdentity;
import simgsm.station.StationOptions;
import simgsm.ui.Appearance;
import simgsm.ui.Display;
import simgsm.ui.Newest;
import simgsm.ui.Symbol;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simgsm.ui.WindowIcon;
import simgsm.ui.WindowKeys;
import simgsm.ui.WindowPlace;

/** The phone in a window: builds it, shows it, and cleans up once it is closed. */
final class PhoneWindow {
    private PhoneWindow() {}

    static int run(
            Arguments arguments,
            StationIdentity identity,
            StationOptions options,
            InetSocketAddress center,
            Texts texts,
            Locale language)
            throws UsageException, InterruptedException {
        Appearance appearance = arguments
                .value("theme", Appearance::parse)
                .orElseGet(() -> Display.isThere() ? Appearance.ofSystem() : Appearance.LIGHT);
        WindowPlace place = arguments.value("window", WindowPlace::parse).orElse(null);
        if (!Display.isThere()) {
            System.err.println("simgsm-phone: there is no display; use --headless for the console");
            return ExitStatus.UNAVAILABLE;
        }
        Phone phone = new Phone(identity, options, new HandsetListener() {}, PhoneMain.sound(arguments));
        CountDownLatch closed = new CountDownLatch(1);
        Runtime.getRuntime().addShutdownHook(new Thread(phone::close, "detach"));
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance);
            open(phone, identity.number(), texts, language, place, closed);
        });
        phone.start(center);
        if (arguments.has("end-with-input")) {
            endWithInput(closed);
        }
        closed.await();
        phone.close();
        return ExitStatus.OK;
    }

    private static void open(
            Phone phone, Msisdn number, Texts texts, Locale language, WindowPlace place, CountDownLatch closed) {
        HandsetSnapshot first = phone.handset().snapshot();
        HandsetPanel panel =
                new HandsetPanel(texts, language, Clock.systemDefaultZone(), first, new PhoneControls(phone));
        JFrame frame = new JFrame(texts.of("window.title") + " " + number);
        frame.setContentPane(panel);
        frame.setIconImages(WindowIcon.images(Symbol.PHONE));
        WindowKeys.install(frame.getRootPane(), language);
        Newest<HandsetSnapshot> newest = new Newest<>(phone.handset()::snapshot, panel::show);
        Timer clock = new Timer(1000, event -> {
            panel.lookAtClock();
            phone.execute(phone.handset()::lookAtSound);
        });
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                newest.stop();
                clock.stop();
                closed.countDown();
            }
        });
        frame.pack();
        if (place == null) {
            frame.setLocationByPlatform(true);
        } else {
            place.take(frame);
        }
        newest.start();
        clock.start();
        frame.setVisible(true);
        panel.requestFocusInWindow();
    }

    /** Whoever started the phone holds its input open; when that ends, the phone ends. */
    private static void endWithInput(CountDownLatch closed) {
        Thread reader = new Thread(
                () -> {
                    try (var input = Program.standardInput()) {
                        while (input.readLine() != null) {
                            // Nothing is expected here but the end.
                        }
                    } catch (IOException e) {
                        // An input that breaks has ended, too.
                    }
                    closed.countDown();
                },
                "input");
        reader.setDaemon(true);
        reader.start();
    }
}
