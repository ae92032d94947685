package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** A status lamp: a mark and a word, both different in each state, which is readable without the colour. */
public final class Lamp extends PaintedComponent {
    private static final int GAP_UNITS = 6;
    private static final double RADIUS_UNITS = 6;
    /** Start of the word. */
    private static final double TEXT_UNITS = 2 * RADIUS_UNITS + 2 + GAP_UNITS;

    private final String subject;
    private StatusMark mark = StatusMark.RING;
    private Ink ink = Ink.QUIET;
    private String word = "";
    private boolean lit = true;
    private String unlitWord = "";
    private boolean isWrapping;

    /** @param subject for assistive technology: "Link to the centre" */
    public Lamp(String subject) {
        super(AccessibleRole.LABEL);
        this.subject = subject;
        setFont(Theme.base());
        setToolTipText(subject);
    }

    /** Shows a state. */
    public void show(StatusMark newMark, Ink newInk, String newWord) {
        if (newMark != mark || newInk != ink || !newWord.equals(word)) {
            mark = newMark;
            ink = newInk;
            boolean resized = !newWord.equals(word);
            change(() -> word = newWord);
            if (resized) {
                setToolTipText(isWrapping && !word.isEmpty() ? word : subject);
                revalidate();
            }
            repaint();
        }
    }

    /** Shows the link to the centre, in the words of all windows. */
    public void show(LinkState link, Locale language) {
        show(link.mark(), link.ink(), link.word(language));
    }

    /** The lamp of every window for the link to the centre. */
    public static Lamp ofLink(Locale language) {
        Lamp lamp = new Lamp(DesktopTexts.in(language).of("link.name"));
        lamp.setName("lamp.link");
        lamp.show(LinkState.SEARCHING, language);
        return lamp;
    }

    /** Lights the lamp or greys its mark; one lamp of a row is lit. */
    public void setLit(boolean nowLit) {
        if (lit != nowLit) {
            change(() -> lit = nowLit);
            repaint();
        }
    }

    /** @param word spoken after the lamp's own word while it is not lit: "off" */
    public Lamp saysWhenUnlit(String word) {
        unlitWord = word;
        return this;
    }

    /** Breaks a too wide word into as many rows as fit the height; the tool tip has the whole word. */
    public Lamp wrapping() {
        isWrapping = true;
        return this;
    }

    /** Height of a wrapping lamp with its whole word at a width in pixels. */
    public int heightFor(int width) {
        double room = width - Theme.exact(TEXT_UNITS);
        int rows = Drawing.wrapped(getFont(), word, room, Integer.MAX_VALUE).size();
        return Math.max(1, rows) * rowHeight();
    }

    private int rowHeight() {
        return Math.max(getFontMetrics(getFont()).getHeight(), Theme.px(2 * RADIUS_UNITS + 4));
    }

    public boolean isLit() {
        return lit;
    }

    /** The word after the mark. */
    public String word() {
        return word;
    }

    @Override
    protected String spoken() {
        String state = lit || unlitWord.isEmpty() ? word : word + ", " + unlitWord;
        return state.isEmpty() ? subject : subject + ": " + state;
    }

    @Override
    public void updateUI() {
        setFont(Theme.base());
        // A lamp has no delegate whose change would renew its style.
        firePropertyChange("UI", false, true);
    }

    @Override
    public Dimension getPreferredSize() {
        int textWidth = word.isEmpty() ? 0 : Drawing.width(getFont(), word) + Theme.px(GAP_UNITS) + 1;
        return new Dimension(Theme.px(2 * RADIUS_UNITS + 2) + 1 + textWidth, rowHeight());
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double r = Theme.exact(RADIUS_UNITS);
        double x = Theme.exact(TEXT_UNITS);
        int most = isWrapping ? Math.max(1, (int) (height / rowHeight())) : 1;
        List<String> rows = Drawing.wrapped(getFont(), word, width - x, most);
        double rowHeight = rows.size() > 1 ? rowHeight() : height;
        double middle = rowHeight / 2;
        mark.draw(new GraphicsCanvas(g), r + Theme.exact(1), middle, r, lit ? ink : Ink.DISABLED);
        g.setFont(getFont());
        g.setColor(Theme.color(lit ? Ink.TEXT : Ink.QUIET));
        for (String row : rows) {
            g.drawString(row, (float) x, (float) (middle + Drawing.capHeight(g, getFont()) / 2));
            middle += rowHeight;
        }
    }
}
