package simrobot.ui;

import java.awt.Dimension;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.ReadingArea;
import simgsm.ui.Theme;

/** A text that wraps to its width; it can be selected and copied. */
public final class WrappedText extends ReadingArea {
    /**
     * @param name for tests;
     * @param spoken description for screen readers
     */
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

    /** Shows another text; an empty one takes no space. */
    public void show(String text) {
        if (!text.equals(getText())) {
            setText(text);
            setVisible(!text.isEmpty());
            revalidate();
        }
    }

    /** Requests the height of its lines, but no width: a text area would keep its current width. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, super.getPreferredSize().height);
    }
}
