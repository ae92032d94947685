package blackbox.face;

import blackbox.SuiteTrace;
import blackbox.VirtualPhone;
import blackbox.VirtualSuite;
import java.awt.Component;
import java.awt.Container;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.subscriber.HomeRegister;
import simgsm.center.ui.CenterActions;
import simgsm.center.ui.MonitorPanel;
import simgsm.center.ui.MonitorWindow;
import simgsm.center.ui.NetworkAccess;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.ui.HandsetControls;
import simgsm.phone.ui.HandsetWindow;
import simgsm.ui.ComponentNames;
import simgsm.ui.window.ProgramWindow;
import simrobot.control.LoggedEvent;
import simrobot.ui.OperatorActions;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.panel.SimRobotWindow;

/** The three windows after a call with an order, a refused order, and a short message; without frames. */
final class SuiteWindows {
    private final VirtualPhone caller;
    private final ExchangeSnapshot center;
    private final WindowSnapshot robot;

    /** Which window. */
    enum Which {
        PHONE,
        ROBOT,
        CENTER
    }

    SuiteWindows() {
        VirtualSuite suite = new VirtualSuite(SuiteTrace.NONE, HomeRegister.OPEN, Optional.empty());
        caller = suite.phone(VirtualSuite.PHONE);
        caller.message("5550299", "** #**20 **");
        suite.seconds(2);
        caller.dial(VirtualSuite.ROBOT);
        suite.seconds(1);
        caller.press("**#**20**");
        suite.seconds(6);
        caller.press("**9");
        suite.seconds(3);
        center = suite.exchange().snapshot();
        TelephoneSnapshot line = new TelephoneSnapshot(
                suite.telephone.name(),
                suite.telephone.number().digits(),
                suite.telephone.modem(),
                suite.telephone.heard(),
                suite.telephone.veriCommand(),
                "1637",
                false);
        List<LoggedEvent> events = List.of();
        robot = new WindowSnapshot(
                suite.simulation.snapshot(),
                List.of(line),
                1,
                false,
                Path.of("worlds", "demo.map"),
                "",
                List.of(),
                events,
                Optional.empty(),
                Optional.empty(),
                false);
    }

    /** On the event thread, in the theme that is installed. */
    JComponent open(Which which, String language) {
        Locale locale = Locale.forLanguageTag(language);
        ProgramWindow.Content content = switch (which) {
            case PHONE ->
                new HandsetWindow(
                                in -> texts("simgsm.phone.messages", in.getLanguage()),
                                () -> speaking(language),
                                nothing(HandsetControls.class),
                                spoken -> {})
                        .content(locale);
            case ROBOT -> SimRobotWindow.content("SimRobot", locale, () -> robot, nothing(OperatorActions.class));
            case CENTER -> MonitorWindow.content(actions(), texts("simgsm.center.app.messages", language));
        };
        content.closed().run();
        if (content.panel() instanceof MonitorPanel monitor) {
            monitor.show(center);
        }
        return content.panel();
    }

    private HandsetSnapshot speaking(String language) {
        caller.handset().set(caller.handset().snapshot().settings().withLanguage(language));
        return caller.handset().snapshot();
    }

    /** The forms of a window: the centre's tabs and a chosen message, the phone's scope and events, the robot as it is. */
    static List<String> forms(Which which) {
        return switch (which) {
            case PHONE -> List.of("closed", "scope", "events");
            case ROBOT -> List.of("plain");
            case CENTER -> List.of("tab 0", "tab 1", "tab 2", "tab 3", "message");
        };
    }

    static void take(JComponent window, String form) {
        if (form.equals("scope") || form.equals("events")) {
            ((AbstractButton) ComponentNames.find(window, form + ".switch").orElseThrow()).doClick(0);
        } else if (form.startsWith("tab")) {
            tabs(window).setSelectedIndex(form.charAt(form.length() - 1) - '0');
        } else if (form.equals("message")) {
            JList<?> ladder =
                    (JList<?>) ComponentNames.find(window, "ladder.list").orElseThrow();
            int setup = IntStream.range(0, ladder.getModel().getSize())
                    .filter(i -> ladder.getModel().getElementAt(i).toString().contains("CP-DATA"))
                    .findFirst()
                    .orElseThrow();
            ladder.setSelectedIndex(setup);
        }
    }

    static JTabbedPane tabs(JComponent window) {
        return (JTabbedPane) ComponentNames.find(window, "tabs").orElseThrow();
    }

    private static TextBundle texts(String bundle, String language) {
        Locale locale = TextBundle.bundleLocale(Locale.forLanguageTag(language));
        return new TextBundle(ResourceBundle.getBundle(bundle, locale), Locale.ROOT);
    }

    private CenterActions actions() {
        return (CenterActions) Proxy.newProxyInstance(
                CenterActions.class.getClassLoader(),
                new Class<?>[] {CenterActions.class},
                (proxy, method, arguments) -> switch (method.getName()) {
                    case "port" -> 3003;
                    case "access" -> NetworkAccess.OPEN;
                    case "snapshot" -> Optional.of(center);
                    default -> null;
                });
    }

    /** Answers everything by nothing. */
    private static <T> T nothing(Class<T> type) {
        return type.cast(Proxy.newProxyInstance(
                type.getClassLoader(),
                new Class<?>[] {type},
                (proxy, method, arguments) -> method.getReturnType() == Optional.class ? Optional.empty() : null));
    }

    /** Sets the size in pixels and lays all out, until nothing moves any more. */
    static void layOut(JComponent window, int width, int height) {
        window.setSize(width, height);
        for (int i = 0; i < 4; i++) {
            layOut(window);
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    static boolean isScrolled(Component component) {
        return SwingUtilities.getAncestorOfClass(JViewport.class, component) != null;
    }
}
