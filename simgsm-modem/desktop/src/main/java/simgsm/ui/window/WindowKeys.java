package simgsm.ui.window;

import java.awt.Component;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Rectangle;
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
                    Optional<Unzoomed> last = Optional.ofNullable((Unzoomed) root.getClientProperty(Unzoomed.class));
                    Unzoomed unzoomed = Unzoomed.of(window.getBounds(), before, last);
                    window.setMinimumSize(null);
                    Display.place(window, unzoomed.at(Theme.zoom()));
                    root.putClientProperty(Unzoomed.class, unzoomed.shown(window.getBounds()));
                    window.validate();
                });
    }

    /**
     * Place, and size at zoom 1, of a window that the screen does not limit.
     *
     * @param shown bounds that the last zoom has left it
     */
    record Unzoomed(Point place, double width, double height, Rectangle shown) {
        /** Keeps place and size of the last one each until the user changes them. */
        static Unzoomed of(Rectangle now, double zoom, Optional<Unzoomed> last) {
            Optional<Unzoomed> sized = last.filter(each -> each.shown.getSize().equals(now.getSize()));
            return new Unzoomed(
                    last.filter(each -> each.shown.getLocation().equals(now.getLocation()))
                            .map(Unzoomed::place)
                            .orElse(now.getLocation()),
                    sized.map(Unzoomed::width).orElse(now.width / zoom),
                    sized.map(Unzoomed::height).orElse(now.height / zoom),
                    now);
        }

        Unzoomed shown(Rectangle now) {
            return new Unzoomed(place, width, height, now);
        }

        Rectangle at(double zoom) {
            return new Rectangle(place.x, place.y, (int) Math.round(width * zoom), (int) Math.round(height * zoom));
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
