package simgsm.ui.lesson;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JEditorPane;
import javax.swing.event.HyperlinkEvent;
import simgsm.draw.Ink;
import simgsm.lesson.Glossary;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** A text that wraps, in which the terms of the glossary are links. */
final class GlossaryText extends JEditorPane {
    private static final int LEAST_PIXELS = 13;

    private final Optional<Glossary> glossary;
    private String shown = "";
    private boolean isBold;

    /** @param glossary whose terms become links; empty for none; @param chosen receives the term that is clicked */
    GlossaryText(String name, Optional<Glossary> glossary, Consumer<String> chosen) {
        this.glossary = glossary;
        setContentType("text/html");
        setEditable(false);
        setOpaque(false);
        setBorder(null);
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        ComponentNames.name(this, name, name);
        addHyperlinkListener(event -> {
            if (event.getEventType() == HyperlinkEvent.EventType.ACTIVATED) {
                chosen.accept(event.getDescription());
            }
        });
    }

    /** Shows its text as a heading. */
    GlossaryText bold() {
        isBold = true;
        return this;
    }

    /** No text of a lesson is smaller than 13 pixels. */
    static Font font(boolean bold) {
        Font font = bold ? Theme.strong() : Theme.base();
        return font.deriveFont(Math.max(LEAST_PIXELS, font.getSize2D()));
    }

    @Override
    public String getText() {
        return shown;
    }

    void show(String text) {
        if (!text.equals(shown)) {
            shown = text;
            getAccessibleContext().setAccessibleName(text);
            super.setText(html());
            revalidate();
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(font(false));
        setForeground(Theme.color(Ink.TEXT));
        setOpaque(false);
        // Nimbus paints the background of a text that is not opaque, too.
        setBackground(Theme.color(Ink.SURFACE, 0));
        if (shown != null && !shown.isEmpty()) {
            super.setText(html());
        }
    }

    private String html() {
        StringBuilder html = new StringBuilder("<html><body style='margin:0'>");
        html.append(isBold ? "<b>" : "");
        String color = String.format("#%06x", Theme.color(Ink.ACCENT).getRGB() & 0xffffff);
        for (Glossary.Part part :
                glossary.map(all -> all.parts(shown)).orElse(java.util.List.of(Glossary.Part.plain(shown)))) {
            String text = escaped(part.text());
            html.append(
                    part.term().isEmpty()
                            ? text
                            : "<a style='color:" + color + "' href='" + escaped(part.term()) + "'>" + text + "</a>");
        }
        return html.append("</body></html>").toString();
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace("'", "&#39;")
                .replace("\n\n", "<br><br>")
                .replace("** ", "**&nbsp;");
    }

    /** As high as its text needs at the present width. */
    @Override
    public Dimension getPreferredSize() {
        int width = 0;
        if (getParent() != null) {
            Insets around = getParent().getInsets();
            width = getParent().getWidth() - around.left - around.right;
        }
        if (width > 0) {
            setSize(width, Short.MAX_VALUE);
        }
        return super.getPreferredSize();
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(1, getPreferredSize().height);
    }
}
