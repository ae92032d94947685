package simrobot.ui;

import java.awt.Dimension;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.ReadingArea;
import simgsm.ui.Theme;

/** A text that breaks into as many lines as it needs; it can be selected and copied. */
public final class WrappedText extends ReadingArea {
    /** @param name for tests; @param spoken what the text is about */
    public WrappedText(String name, String spoken, Ink ink) {
        super("");
        ComponentNames.name(this, name, spoken);
        setOpaque(false);
        setVisible(false);
        Theme.styled(this, area -> {
            area.setForeground(Theme.color(ink));
            area.setFont(Theme.base());
        });
    }

    /** Shows another text; without one the component takes no room. */
    public void show(String text) {
        if (!text.equals(getText())) {
            setText(text);
            setVisible(!text.isEmpty());
            revalidate();
        }
    }

    /** Asks for the height of its lines, but for no width: a text area would keep the width that it has now. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, super.getPreferredSize().height);
    }
}
