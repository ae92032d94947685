package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.awt.KeyboardFocusManager;
import javax.swing.JEditorPane;
import javax.swing.JPanel;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.glossary.GlossaryText;

/** A teacher's sheet of a lesson: time, course, steps, answers, usual mistakes. Needs no display. */
public final class SheetPanel extends JPanel {
    private final String markdown;
    private final JEditorPane text;

    /** @param markdown the sheet; @param name of the text, for assistive technology */
    public SheetPanel(String markdown, String name) {
        super(new BorderLayout());
        this.markdown = markdown;
        text = new JEditorPane() {
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
        fill();
        text.setBorder(Theme.padding(12));
        add(new VerticalScrollPane(ComponentNames.name(text, "sheet.text", name)).bare(), BorderLayout.CENTER);
        setBackground(Theme.color(Ink.SURFACE));
    }

    /** Renews the HTML, which contains the colours. */
    private void fill() {
        text.setText(SheetHtml.of(markdown, css(Ink.ACCENT_WASH), css(Ink.TEXT), GlossaryText.font(false)));
        text.setCaretPosition(0);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null) {
            setBackground(Theme.color(Ink.SURFACE));
            fill();
        }
    }

    private static String css(Ink ink) {
        return String.format("#%06x", Theme.color(ink).getRGB() & 0xffffff);
    }
}
