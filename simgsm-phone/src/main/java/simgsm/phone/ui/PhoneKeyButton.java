package simgsm.phone.ui;

import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.KeyEvent;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.phone.screen.PhoneKey;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;

/** A key of the handset, pressed by the mouse, the space bar or assistive technology. */
final class PhoneKeyButton extends JButton {
    private final PhoneKey key;
    private final PhoneKeyPainter painter;
    private boolean down;
    private boolean sounding;
    private int unread;

    PhoneKeyButton(PhoneKey key, TextBundle texts, HandsetControls controls) {
        this.key = key;
        this.painter = new PhoneKeyPainter(key, texts);
        setContentAreaFilled(false);
        setBorderPainted(false);
        setFocusPainted(false);
        setOpaque(false);
        // A click leaves the focus on the panel, which handles the keyboard; Tab still reaches every key.
        setRequestFocusEnabled(false);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        getModel().addChangeListener(event -> follow(controls));
        String description = texts.of("key." + key.name().toLowerCase(Locale.ROOT));
        ComponentNames.name(this, nameOf(key), description);
        setToolTipText(tip(texts, description));
        // Enter is bound by the panel wherever the focus is; the space bar presses the focused key.
        getInputMap().put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0, false), "none");
        getInputMap().put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0, true), "none");
    }

    /** The name of the key and of the corresponding key of the keyboard. */
    private String tip(TextBundle texts, String description) {
        return switch (key) {
            case CALL -> texts.of("key.tip", description, texts.of("keyboard.enter") + ", F6");
            case OK -> texts.of("key.tip", description, texts.of("keyboard.enter"));
            case END -> texts.of("key.tip", description, "Esc");
            case MESSAGE -> texts.of("key.tip", description, "F2");
            case MENU -> texts.of("key.tip", description, "F3");
            case CLEAR -> texts.of("key.tip", description, texts.of("keyboard.backspace"));
            case SOFT_LEFT -> texts.of("key.tip", description, "F4");
            case SOFT_RIGHT -> texts.of("key.tip", description, "F5");
            default -> description;
        };
    }

    /** The component name for tests: {@code key.5}, {@code key.call}. */
    static String nameOf(PhoneKey key) {
        return "key."
                + key.tone()
                        .map(tone -> String.valueOf(tone.symbol()))
                        .orElse(key.name().toLowerCase(Locale.ROOT));
    }

    private void follow(HandsetControls controls) {
        boolean nowDown = getModel().isPressed() && getModel().isArmed();
        if (nowDown == down) {
            return;
        }
        down = nowDown;
        if (nowDown) {
            controls.keyDown(key);
        } else {
            controls.keyUp(key);
        }
        repaint();
    }

    /** Highlights the key while its tone sounds. */
    void setSounding(boolean nowSounding) {
        if (sounding != nowSounding) {
            sounding = nowSounding;
            repaint();
        }
    }

    /** Shows the number of unread messages, on key 1. */
    void setUnread(int count, String description) {
        if (unread != count) {
            unread = count;
            getAccessibleContext().setAccessibleName(description);
            repaint();
        }
    }

    /** Sets the function of a key under the display, for screen readers. */
    void setMeaning(String words) {
        getAccessibleContext().setAccessibleDescription(words);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            painter.paint(
                    g,
                    getWidth(),
                    getHeight(),
                    new PhoneKeyPainter.Look(down, sounding, getModel().isRollover(), isFocusOwner(), unread));
        } finally {
            g.dispose();
        }
    }
}
