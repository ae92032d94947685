package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Frame;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Optional;
import javax.swing.Action;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import javax.swing.RootPaneContainer;
import javax.swing.SwingUtilities;
import simgsm.draw.Ink;
import simgsm.scope.ToneTrace;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** A scope in its own window, which is closed with its opener's. */
record LargeScope(JDialog dialog, ToneScopePanel panel) {
    private static final int WIDTH = 720;
    private static final int HEIGHT = 560;

    /** @param place in pixels of the screen; empty for the middle of the owner */
    static LargeScope open(ToneScopePanel owner, Optional<Rectangle> place) {
        Window window = SwingUtilities.getWindowAncestor(owner);
        String name = DesktopTexts.in(owner.language()).of("scope.name");
        JDialog dialog = new JDialog(window, window instanceof Frame frame ? name + " - " + frame.getTitle() : name);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                owner.conceal(false);
            }
        });
        ToneScopePanel panel = owner.enlarged();
        JPanel content = new JPanel(new BorderLayout());
        Theme.styled(content, it -> {
            it.setBackground(Theme.color(Ink.CARD));
            it.setBorder(Theme.padding(12));
        });
        content.add(panel);
        dialog.setContentPane(content);
        bindKeys(dialog, window, name);
        place.ifPresentOrElse(dialog::setBounds, () -> {
            Rectangle room = room(window);
            dialog.setSize(Math.min(Theme.px(WIDTH), room.width), Math.min(Theme.px(HEIGHT), room.height));
            dialog.setLocationRelativeTo(owner);
        });
        dialog.setVisible(true);
        return new LargeScope(dialog, panel);
    }

    /** The screen area without the desktop's bars, in pixels. */
    private static Rectangle room(Window window) {
        Rectangle screen = window.getGraphicsConfiguration().getBounds();
        Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(window.getGraphicsConfiguration());
        return new Rectangle(
                screen.x + bars.left,
                screen.y + bars.top,
                screen.width - bars.left - bars.right,
                screen.height - bars.top - bars.bottom);
    }

    /** Escape closes the window; keys of the owner's frame, such as help and zoom, also work here. */
    private static void bindKeys(JDialog dialog, Window owner, String name) {
        JRootPane root = dialog.getRootPane();
        if (owner instanceof RootPaneContainer frame) {
            InputMap keys = frame.getRootPane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW);
            for (KeyStroke stroke : Optional.ofNullable(keys.keys()).orElse(new KeyStroke[0])) {
                Object id = keys.get(stroke);
                Action action = frame.getRootPane().getActionMap().get(id);
                if (action != null) {
                    root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, id);
                    root.getActionMap().put(id, action);
                }
            }
        }
        new UserAction("scope.close", name, dialog::dispose)
                .bindInWindow(root, KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
    }

    boolean isOpen() {
        return dialog.isVisible();
    }

    void toFront() {
        dialog.toFront();
    }

    void show(ToneTrace trace) {
        if (isOpen()) {
            panel.show(trace);
        }
    }
}
