package simgsm.phone.ui;

import java.awt.Dimension;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** The row below the keys: buttons of the folds and the state of the sound, in words if there is room. */
final class HandsetFooter extends JPanel {
    private static final int ICON = 12;

    private final TextBundle texts;
    private final Map<HandsetFold, JButton> switches = new EnumMap<>(HandsetFold.class);
    private final JLabel sound = new JLabel();
    private String soundWords = "";

    /** @param toggled opens or closes a fold */
    HandsetFooter(TextBundle texts, Consumer<HandsetFold> toggled) {
        super(null);
        this.texts = texts;
        setOpaque(false);
        add(
                HandsetFold.SCOPE,
                new UserAction("scope.switch", texts.of("scope.open"), () -> toggled.accept(HandsetFold.SCOPE)));
        add(
                HandsetFold.EVENTS,
                new UserAction("events.switch", texts.of("events.title"), () -> toggled.accept(HandsetFold.EVENTS)));
        sound.setHorizontalAlignment(JLabel.TRAILING);
        add(ComponentNames.name(sound, "sound", texts.of("sound.off")));
        dress();
    }

    private void add(HandsetFold fold, UserAction action) {
        JButton button = new JButton(action.in(CommandGroup.VIEW));
        button.setContentAreaFilled(false);
        button.setHorizontalAlignment(JButton.LEADING);
        button.setRequestFocusEnabled(false);
        switches.put(fold, ComponentNames.name(button, action.id(), action.name()));
        add(button);
    }

    void setToolTip(HandsetFold fold, String tip) {
        switches.get(fold).setToolTipText(tip);
    }

    /** Shows which fold is open. */
    void show(HandsetFold open) {
        switches.forEach((fold, button) -> button.setIcon((fold == open ? Symbol.UP : Symbol.DOWN).icon(ICON)));
    }

    void showSound(boolean audible) {
        sound.setIcon((audible ? Symbol.SPEAKER : Symbol.SPEAKER_OFF).icon());
        soundWords = audible ? "" : texts.of("sound.off");
        sound.setToolTipText(texts.of(audible ? "sound.on" : "sound.off"));
        doLayout();
    }

    @Override
    public void doLayout() {
        int x = 0;
        for (JButton button : switches.values()) {
            Dimension size = button.getPreferredSize();
            button.setBounds(x, 0, size.width, getHeight());
            x += size.width + Theme.px(4);
        }
        int room = getWidth() - x;
        sound.setText(soundWords);
        if (sound.getPreferredSize().width > room) {
            sound.setText("");
        }
        sound.setBounds(x, 0, Math.max(0, room), getHeight());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (sound != null) {
            dress();
        }
    }

    private void dress() {
        sound.setFont(Theme.small());
        sound.setForeground(Theme.color(Ink.QUIET));
        for (JButton button : switches.values()) {
            button.setFont(Theme.small());
            button.setForeground(Theme.color(Ink.QUIET));
            button.setBorder(Theme.padding(2));
        }
    }
}
