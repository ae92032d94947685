package simgsm.ui.window;

import java.awt.Component;
import java.awt.Dialog;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import javax.swing.RootPaneContainer;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.ui.CommandGroup;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** The keys of every window: zoom with Ctrl +, - and 0, light, dark or high contrast with Ctrl L. */
public final class WindowKeys {
    private WindowKeys() {}

    /**
     * Binds the keys. The anchor's window is resized with the zoom.
     *
     * @param anchor a component that stays in the window, such as its root pane
     * @return the actions, for menus: larger, smaller, normal size, next appearance
     */
    public static List<UserAction> install(JComponent anchor, Locale language) {
        TextBundle texts = DesktopTexts.in(language);
        UserAction in = new UserAction("window.zoom.in", texts.of("window.zoom.in"), () -> zoom(anchor, 1))
                .in(CommandGroup.WINDOW);
        UserAction out = new UserAction("window.zoom.out", texts.of("window.zoom.out"), () -> zoom(anchor, -1))
                .in(CommandGroup.WINDOW);
        UserAction reset = new UserAction("window.zoom.reset", texts.of("window.zoom.reset"), () -> zoom(anchor, 0))
                .in(CommandGroup.WINDOW);
        UserAction appearance = new UserAction(
                        "window.appearance", texts.of("window.appearance"), () -> switchAppearance(anchor))
                .in(CommandGroup.WINDOW);
        in.bindInWindow(anchor, ctrl(KeyEvent.VK_PLUS), ctrl(KeyEvent.VK_ADD), ctrl(KeyEvent.VK_EQUALS), ctrlShift());
        out.bindInWindow(anchor, ctrl(KeyEvent.VK_MINUS), ctrl(KeyEvent.VK_SUBTRACT));
        reset.bindInWindow(anchor, ctrl(KeyEvent.VK_0), ctrl(KeyEvent.VK_NUMPAD0));
        appearance.bindInWindow(anchor, ctrl(KeyEvent.VK_L));
        return List.of(in, out, reset, appearance);
    }

    /** Binds the keys of a window beside the program's main one, and F1 to the main one's help. */
    public static void installBeside(JComponent anchor, Locale language) {
        install(anchor, language);
        Runnable help = () -> openHelp(windows().map(SwingUtilities::getRootPane));
        new UserAction("window.help.main", DesktopTexts.in(language).of("window.help"), help)
                .in(CommandGroup.WINDOW)
                .bindInWindow(anchor, KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
    }

    /** Opens the help of the first window that has one. */
    static void openHelp(Stream<JRootPane> windows) {
        windows.filter(Objects::nonNull)
                .map(each -> each.getActionMap().get("window.help"))
                .filter(Objects::nonNull)
                .findFirst()
                .ifPresent(help -> help.actionPerformed(null));
    }

    /** Gives the whole window the next appearance: light, dark, high contrast. */
    public static void switchAppearance(JComponent anchor) {
        Theme.install(Theme.appearance().next());
        refreshAll(anchor);
    }

    private static void zoom(JComponent anchor, int steps) {
        zoomTo(anchor, steps == 0 ? 1 : Theme.zoomed(steps));
    }

    /** Sets the zoom of all windows, and sizes that fit. */
    static void zoomTo(JComponent anchor, double zoom) {
        double before = Theme.zoom();
        Theme.zoomTo(zoom);
        refreshAll(anchor);
        windows()
                .filter(each -> each instanceof Frame || each instanceof Dialog)
                .forEach(window -> {
                    JRootPane root = ((RootPaneContainer) window).getRootPane();
                    Optional<SizeAtOne> last = Optional.ofNullable((SizeAtOne) root.getClientProperty(SizeAtOne.class));
                    SizeAtOne size = SizeAtOne.of(window.getSize(), before, last);
                    window.setMinimumSize(null);
                    Display.resize(window, size.width(Theme.zoom()), size.height(Theme.zoom()));
                    root.putClientProperty(SizeAtOne.class, size.shown(window.getSize()));
                    window.validate();
                });
    }

    /**
     * The size of a window at zoom 1.
     *
     * @param shown size at the last zoom, which the screen may have limited
     */
    record SizeAtOne(double width, double height, Dimension shown) {
        /** Keeps the last one while the window has the size that the last zoom left it. */
        static SizeAtOne of(Dimension now, double zoom, Optional<SizeAtOne> last) {
            return last.filter(each -> each.shown.equals(now))
                    .orElseGet(() -> new SizeAtOne(now.width / zoom, now.height / zoom, now));
        }

        SizeAtOne shown(Dimension now) {
            return new SizeAtOne(width, height, now);
        }

        int width(double zoom) {
            return (int) Math.round(width * zoom);
        }

        int height(double zoom) {
            return (int) Math.round(height * zoom);
        }
    }

    private static Stream<Window> windows() {
        return Stream.of(Window.getWindows()).filter(Component::isDisplayable);
    }

    /** All windows of a program change: also a large tone scope, the help and the class. */
    private static void refreshAll(JComponent anchor) {
        if (SwingUtilities.getWindowAncestor(anchor) == null) {
            Theme.refresh(anchor);
        }
        windows().forEach(Theme::refresh);
    }

    private static KeyStroke ctrl(int key) {
        return KeyStroke.getKeyStroke(key, InputEvent.CTRL_DOWN_MASK);
    }

    /** On many keyboards the plus sign is a shifted equals sign. */
    private static KeyStroke ctrlShift() {
        return KeyStroke.getKeyStroke(KeyEvent.VK_EQUALS, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
    }
}
