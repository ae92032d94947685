package blackbox.pictures;

import blackbox.VirtualPhone;
import blackbox.VirtualSuite;
import blackbox.face.IdleProgram;
import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.ResourceBundle;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JScrollBar;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import simgsm.center.app.CenterTexts;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.ui.CenterActions;
import simgsm.center.ui.MonitorPanel;
import simgsm.center.ui.MonitorWindow;
import simgsm.center.ui.NetworkAccess;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.ui.HandsetPanel;
import simgsm.ui.Theme;
import simgsm.ui.window.ProgramWindow;
import simrobot.control.RobotEvent;
import simrobot.control.TelephoneRobot;
import simrobot.ui.OperatorActions;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.panel.SimRobotPanel;

/** The three windows of a suite as one picture, as the demo places them: each panel in a frame with its title. */
final class SuitePicture {
    static final int WIDTH = 1_600;
    static final int HEIGHT = 1_000;
    private static final int TITLE_HEIGHT = 26;
    private static final Rectangle PHONE = new Rectangle(0, 0, 340, 700);
    private static final Rectangle ROBOT = new Rectangle(344, 0, WIDTH - 344, 610);
    private static final Rectangle CENTER = new Rectangle(344, 614, WIDTH - 344, HEIGHT - 614);
    private static final Color DESKTOP = new Color(0x3A4A5E);
    private static final int PORT = 3003;
    private static final long SECOND_NANOS = 1_000_000_000;

    private final VirtualSuite suite;
    private final VirtualPhone phone;
    private final HandsetPanel handset;
    private final SimRobotPanel robot;
    private final MonitorPanel center;
    private final String robotTitle;
    private final String phoneTitle;
    private String sentTones = "";
    private long tickedNanos;

    /** On the event thread. */
    SuitePicture(VirtualSuite suite, VirtualPhone phone, Locale language) {
        this.suite = suite;
        this.phone = phone;
        TextBundle texts = new TextBundle(
                ResourceBundle.getBundle("simgsm.phone.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
        Clock noon = Clock.fixed(Instant.parse("2026-11-21T12:00:00Z"), ZoneOffset.UTC);
        handset = new HandsetPanel(texts, language, noon, phone.handset().snapshot(), action -> {});
        robot = new SimRobotPanel(language, window(), IdleProgram.behind(OperatorActions.class, Map.of()));
        ProgramWindow.Content monitor = MonitorWindow.content(new Watched(), CenterTexts.in(language));
        // Its timers tell real time.
        monitor.closed().run();
        center = (MonitorPanel) monitor.panel();
        List.of(handset, robot, center).forEach(SuitePicture::settle);
        phoneTitle = texts.of("window.title") + " " + VirtualSuite.PHONE;
        robotTitle = "SimRobot " + VirtualSuite.ROBOT;
        suite.telephone.listen(event -> {
            if (event instanceof RobotEvent.CallReceived) {
                sentTones = "";
            } else if (event instanceof RobotEvent.ToneSent tone) {
                sentTones += tone.key();
            }
        });
    }

    /** Tables show their headers, and buttons of choices and scroll bars their looks, once they are in a window. */
    private static void settle(Container container) {
        for (Component child : container.getComponents()) {
            if (child instanceof JTable table) {
                table.addNotify();
            } else if (child instanceof JComboBox || child instanceof JScrollBar) {
                SwingUtilities.updateComponentTreeUI(child);
            } else if (child instanceof Container inner) {
                settle(inner);
            }
        }
    }

    HandsetPanel handset() {
        return handset;
    }

    /** Shows the suite's present state in all windows. */
    void refresh() {
        handset.show(phone.handset().snapshot());
        robot.show(window());
        center.show(suite.exchange().snapshot());
        if (suite.nowNanos() - tickedNanos >= SECOND_NANOS) {
            tickedNanos = suite.nowNanos();
            center.tick(tickedNanos);
        }
    }

    private WindowSnapshot window() {
        TelephoneRobot telephone = suite.telephone;
        TelephoneSnapshot line = new TelephoneSnapshot(
                telephone.name(),
                telephone.number().digits(),
                telephone.modem(),
                telephone.heard(),
                telephone.veriCommand(),
                sentTones,
                "",
                false);
        return new WindowSnapshot(
                suite.simulation.snapshot(),
                List.of(line),
                1,
                false,
                Path.of("worlds", suite.simulation.world().name()),
                "",
                List.of(),
                List.of(),
                Optional.empty(),
                Optional.empty(),
                false);
    }

    /** Lays all three windows out as the demo places them. */
    void arrange() {
        lay(handset, PHONE);
        lay(robot, ROBOT);
        lay(center, CENTER);
    }

    void arrangePhone(int height) {
        lay(handset, new Rectangle(0, 0, PHONE.width, height));
    }

    void arrangeRobot(int width, int height) {
        lay(robot, new Rectangle(0, 0, width, height));
    }

    void arrangeCenter(int width, int height) {
        lay(center, new Rectangle(0, 0, width, height));
    }

    /** All three windows. */
    BufferedImage all(double scale) {
        return image(WIDTH, HEIGHT, scale, g -> {
            g.setColor(DESKTOP);
            g.fillRect(0, 0, WIDTH, HEIGHT);
            paint(g, handset, PHONE, phoneTitle);
            paint(g, robot, ROBOT, robotTitle);
            paint(g, center, CENTER, "SMSyCT");
        });
    }

    /** The phone's window as it was arranged; likewise the others. */
    BufferedImage phone() {
        return one(handset, phoneTitle);
    }

    BufferedImage robot() {
        return one(robot, robotTitle);
    }

    BufferedImage center() {
        return one(center, "SMSyCT");
    }

    private static BufferedImage one(JComponent panel, String title) {
        int height = panel.getHeight() + TITLE_HEIGHT;
        return image(
                panel.getWidth(),
                height,
                1,
                g -> paint(g, panel, new Rectangle(0, 0, panel.getWidth(), height), title));
    }

    private interface Painter {
        void paint(Graphics2D g);
    }

    private static BufferedImage image(int width, int height, double scale, Painter painter) {
        BufferedImage image = new BufferedImage(
                (int) Math.round(width * scale), (int) Math.round(height * scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.scale(scale, scale);
        painter.paint(g);
        g.dispose();
        return image;
    }

    private static void paint(Graphics2D graphics, JComponent panel, Rectangle place, String title) {
        Graphics2D g = (Graphics2D) graphics.create(place.x, place.y, place.width, place.height);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Theme.color(Ink.BODY));
        g.fillRect(0, 0, place.width, place.height);
        g.setColor(Theme.color(Ink.TEXT));
        g.setFont(Theme.strong());
        g.drawString(title, (place.width - g.getFontMetrics().stringWidth(title)) / 2, 18);
        g.translate(0, TITLE_HEIGHT);
        g.clipRect(0, 0, place.width, place.height - TITLE_HEIGHT);
        panel.printAll(g);
        g.dispose();
    }

    /** Some components know their place only once the one around them has been laid out, so all is laid out twice. */
    private static void lay(JComponent panel, Rectangle place) {
        panel.setSize(place.width, place.height - TITLE_HEIGHT);
        layOut(panel);
        layOut(panel);
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** The centre as its window sees it; its buttons are not pressed here. */
    private final class Watched implements CenterActions {
        @Override
        public int port() {
            return PORT;
        }

        @Override
        public NetworkAccess access() {
            return NetworkAccess.OPEN;
        }

        @Override
        public Optional<ExchangeSnapshot> snapshot() {
            return Optional.of(suite.exchange().snapshot());
        }

        @Override
        public void broadcast(BroadcastOrder order) {
            throw new UnsupportedOperationException("a picture");
        }

        @Override
        public void stopBroadcast(int id) {
            throw new UnsupportedOperationException("a picture");
        }

        @Override
        public void newPhone() {
            throw new UnsupportedOperationException("a picture");
        }

        @Override
        public void newRobot() {
            throw new UnsupportedOperationException("a picture");
        }

        @Override
        public void quit() {
            throw new UnsupportedOperationException("a picture");
        }
    }
}
