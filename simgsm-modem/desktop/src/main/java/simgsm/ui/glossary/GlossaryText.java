package simgsm.ui.glossary;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JEditorPane;
import javax.swing.KeyStroke;
import javax.swing.event.HyperlinkEvent;
import javax.swing.text.DefaultCaret;
import simgsm.draw.Ink;
import simgsm.draw.SvgCanvas;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * A text that wraps, in which the terms of the glossary are links. With the keyboard, Tab selects a text with terms,
 * the arrows a term, and Enter or Space chooses it.
 */
public final class GlossaryText extends JEditorPane {
    private static final int LEAST_PIXELS = 13;

    private static final Pattern TERM = Pattern.compile("(^|<br><br>)([^:]+?):");

    /** Steps among the terms. */
    private static final Map<Integer, Integer> KEYS =
            Map.of(KeyEvent.VK_RIGHT, 1, KeyEvent.VK_DOWN, 1, KeyEvent.VK_LEFT, -1, KeyEvent.VK_UP, -1);

    private final Optional<Glossary> glossary;
    private String shown = "";
    private boolean isBold;
    /** True for explanations: the term before each colon is bold. */
    private boolean areTermsBold;
    /** The term selected by the keyboard; -1 for none. */
    private int at = -1;

    /** A text without links; the beginning of each paragraph up to its colon is bold. */
    public static GlossaryText ofExplanations(String name) {
        GlossaryText text = new GlossaryText(name, Optional.empty(), term -> {});
        text.areTermsBold = true;
        return text;
    }

    /** @param glossary of the linked terms; empty for none; @param chosen receives the term that is clicked */
    public GlossaryText(String name, Optional<Glossary> glossary, Consumer<String> chosen) {
        this.glossary = glossary;
        setContentType("text/html");
        setEditable(false);
        setOpaque(false);
        ComponentNames.name(this, name, name);
        setFocusable(false);
        bindKeys(chosen);
        followFocus();
        setCaret(new HiddenCaret());
        addHyperlinkListener(event -> {
            if (event.getEventType() == HyperlinkEvent.EventType.ACTIVATED) {
                chosen.accept(event.getDescription());
            }
        });
    }

    private void bindKeys(Consumer<String> chosen) {
        // Otherwise Tab would be inserted, as in an editable text.
        setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        KEYS.forEach((key, step) -> new UserAction("term." + key, "", () -> move(step))
                .bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0)));
        for (int key : new int[] {KeyEvent.VK_ENTER, KeyEvent.VK_SPACE}) {
            new UserAction(
                            "term." + key,
                            "",
                            () -> terms().skip(Math.max(0, at)).findFirst().ifPresent(chosen))
                    .bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
        }
    }

    private void followFocus() {
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                move(at < 0 ? 1 : 0);
            }

            @Override
            public void focusLost(FocusEvent event) {
                at = -1;
                move(0);
            }
        });
    }

    private Stream<String> terms() {
        return parts().stream().map(Glossary.Part::term).filter(term -> !term.isEmpty());
    }

    /** Moves to another term. */
    private void move(int step) {
        int last = (int) terms().count() - 1;
        at = step == 0 ? at : Math.max(0, Math.min(last, at + step));
        super.setText(html());
    }

    /** Shows its text as a heading. */
    public GlossaryText bold() {
        isBold = true;
        super.setText(html());
        return this;
    }

    /** No text of a lesson is smaller than 13 pixels. */
    public static Font font(boolean bold) {
        Font font = bold ? Theme.strong() : Theme.base();
        return font.deriveFont(Math.max(LEAST_PIXELS, font.getSize2D()));
    }

    @Override
    public String getText() {
        return shown;
    }

    public void show(String text) {
        if (!text.equals(shown)) {
            shown = text;
            getAccessibleContext().setAccessibleName(text);
            at = -1;
            setFocusable(glossary.isPresent() && glossary.get().hasTerms(shown));
            super.setText(html());
            revalidate();
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(null);
        // Nimbus takes it away with the look that it replaces.
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        setFont(font(false));
        setForeground(Theme.color(Ink.TEXT));
        setOpaque(false);
        // Nimbus also paints the background of a text that is not opaque.
        setBackground(Theme.color(Ink.SURFACE, 0));
        if (shown != null && !shown.isEmpty()) {
            super.setText(html());
        }
    }

    private static String web(Ink ink) {
        return String.format("#%06x", Theme.color(ink).getRGB() & 0xffffff);
    }

    private List<Glossary.Part> parts() {
        return glossary.map(all -> all.parts(shown)).orElse(List.of(Glossary.Part.plain(shown)));
    }

    private String html() {
        StringBuilder html = new StringBuilder("<html><body style='margin:0'>");
        html.append(isBold ? "<b>" : "");
        String color = web(Ink.ACCENT);
        String wash = web(Ink.ACCENT_WASH);
        int number = 0;
        for (Glossary.Part part : parts()) {
            String text = escaped(part.text());
            if (areTermsBold) {
                text = TERM.matcher(text).replaceAll("$1<b>$2</b>:");
            }
            if (!part.term().isEmpty() && number++ == at) {
                text = "<span style='background:" + wash + "'>" + text + "</span>";
            }
            html.append(
                    part.term().isEmpty()
                            ? text
                            : "<a style='color:" + color + "' href='" + escaped(part.term()) + "'>" + text + "</a>");
        }
        return html.append("</body></html>").toString();
    }

    private static String escaped(String text) {
        return Stream.of(text.split("\n\n", -1))
                .map(SvgCanvas::escaped)
                .collect(Collectors.joining("<br><br>"))
                // Words of more than 24 characters would be cut at the edge: a path is broken after a folder.
                .replaceAll("([^\\s&;<>]{11,23}/)(?=[^\\s<])", "$1<br>")
                .replaceAll("([^\\s&;<>]{24})(?=[^\\s&;<>])", "$1<br>")
                .replace("** ", "**&nbsp;")
                .replaceAll("(?<=[0-9]) \\*\\*", "&nbsp;**");
    }

    /** As high as the text needs at the current width. */
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

    private static final class HiddenCaret extends DefaultCaret {
        @Override
        public void setVisible(boolean visible) {
            super.setVisible(false);
        }

        /** A new text keeps the scroll position of its list. */
        @Override
        protected void adjustVisibility(Rectangle place) {
            // Nothing is written that the view has to follow.
        }
    }
}
