package simgsm.ui;

import java.awt.Component;
import javax.swing.JScrollPane;

/** A scroll pane that scrolls vertically only. */
public class VerticalScrollPane extends JScrollPane {
    public VerticalScrollPane(Component view) {
        super(view, VERTICAL_SCROLLBAR_AS_NEEDED, HORIZONTAL_SCROLLBAR_NEVER);
    }

    /** Removes border and background in every appearance. @return this */
    public VerticalScrollPane bare() {
        setOpaque(false);
        getViewport().setOpaque(false);
        return Theme.styled(this, pane -> {
            pane.setBorder(null);
            pane.setViewportBorder(null);
        });
    }
}
