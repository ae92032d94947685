package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.KeyboardFocusManager;
import javax.swing.JEditorPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** A teacher's sheet of a lesson: time, course, steps, answers, what goes wrong. Needs no display. */
public final class SheetPanel extends JPanel {
    /** @param markdown the sheet; @param name of what is shown, for assistive technology */
    public SheetPanel(String markdown, String name) {
        super(new BorderLayout());
        JEditorPane text = new JEditorPane() {
            @Override
            public void updateUI() {
                super.updateUI();
                setFont(GlossaryText.font(false));
                setForeground(Theme.color(Ink.TEXT));
                setBackground(Theme.color(Ink.SURFACE, 0));
                setOpaque(false);
            }
        };
        text.setContentType("text/html");
        text.putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        text.setEditable(false);
        text.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        text.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        text.updateUI();
        Color head = Theme.color(Ink.ACCENT_WASH);
        text.setText(SheetHtml.of(markdown, String.format("#%06x", head.getRGB() & 0xffffff)));
        text.setCaretPosition(0);
        text.setBorder(Theme.padding(12));
        JScrollPane scroll = new JScrollPane(ComponentNames.name(text, "sheet.text", name));
        scroll.setBorder(null);
        scroll.getViewport().setOpaque(false);
        scroll.setOpaque(false);
        scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        add(scroll, BorderLayout.CENTER);
        setBackground(Theme.color(Ink.SURFACE));
    }
}
