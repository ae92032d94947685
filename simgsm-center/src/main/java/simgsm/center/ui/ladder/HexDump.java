package simgsm.center.ui.ladder;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.BitSet;
import java.util.HexFormat;
import java.util.function.IntConsumer;
import java.util.function.IntSupplier;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.octets.OctetString;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * The octets of a message in hexadecimal, 16, 8 or 4 in a line, as many as the width holds whole. Those of a field are
 * marked; the arrows and the mouse choose one.
 *
 * <pre>
 *   0000  03 05 04 06 60 04 02 00
 *   0008  05 81 5e 06 91 55 05 02
 * </pre>
 */
final class HexDump extends PaintedComponent {
    private static final int MOST_PER_LINE = 16;
    private static final int LEAST_PER_LINE = 4;
    /** The offset and two blanks; each octet has two digits and a blank. */
    private static final int OFFSET_LETTERS = 6;

    private static final int LINE_UNITS = 20;
    private static final int MARGIN_UNITS = 6;

    private final TextBundle texts;
    private final IntConsumer chosen;
    private OctetString octets = OctetString.of(new byte[0]);
    private BitSet marked = new BitSet();
    private String field = "";
    private int cursor = -1;

    /** @param chosen receives the index of each selected octet, from 0 */
    HexDump(TextBundle texts, IntConsumer chosen) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.chosen = chosen;
        setName("ladder.octets");
        makeFocusable();
        bind(KeyEvent.VK_LEFT, () -> -1);
        bind(KeyEvent.VK_RIGHT, () -> 1);
        bind(KeyEvent.VK_UP, () -> -perLine());
        bind(KeyEvent.VK_DOWN, this::perLine);
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                requestFocusInWindow();
                int octet = octetAt(event.getX(), event.getY());
                if (octet >= 0) {
                    choose(octet);
                }
            }
        });
    }

    private void bind(int key, IntSupplier step) {
        new UserAction("octet." + key, "", () -> choose(Math.max(0, cursor) + (cursor < 0 ? 0 : step.getAsInt())))
                .bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
    }

    /** Shows a message's octets without marks. */
    void show(OctetString newOctets) {
        octets = newOctets;
        cursor = -1;
        mark(new BitSet(), "");
        revalidate();
    }

    /** Marks the octets of a field. */
    void mark(BitSet newMarked, String newField) {
        change(() -> {
            marked = newMarked;
            field = newField;
        });
        repaint();
        if (!marked.isEmpty()) {
            scrollRectToVisible(placeOf(marked.nextSetBit(0)));
        }
    }

    BitSet marked() {
        return (BitSet) marked.clone();
    }

    /** Selects an octet by key or mouse; ignores an index out of range. */
    void choose(int octet) {
        if (octet >= 0 && octet < octets.length()) {
            cursor = octet;
            chosen.accept(octet);
            scrollRectToVisible(placeOf(octet));
            repaint();
        }
    }

    private static double letter() {
        return Drawing.width(Theme.mono(), "0000000000") / 10.0;
    }

    /** The width of lines with this number of octets, in pixels. */
    static int widthOf(int perLine) {
        return (int) Math.ceil((OFFSET_LETTERS + 3 * perLine - 1) * letter()) + 2 * Theme.px(MARGIN_UNITS);
    }

    private int perLine() {
        int perLine = MOST_PER_LINE;
        while (perLine > LEAST_PER_LINE && getWidth() > 0 && widthOf(perLine) > getWidth()) {
            perLine /= 2;
        }
        return perLine;
    }

    private Rectangle placeOf(int octet) {
        int perLine = perLine();
        int x = (int) (Theme.px(MARGIN_UNITS) + (OFFSET_LETTERS + 3 * (octet % perLine)) * letter());
        int y = Theme.px(MARGIN_UNITS) + octet / perLine * Theme.px(LINE_UNITS);
        return new Rectangle(x, y, (int) Math.ceil(2 * letter()), Theme.px(LINE_UNITS));
    }

    private int octetAt(int x, int y) {
        for (int octet = 0; octet < octets.length(); octet++) {
            Rectangle place = placeOf(octet);
            place.grow((int) letter() / 2, 0);
            if (place.contains(x, y)) {
                return octet;
            }
        }
        return -1;
    }

    @Override
    public Dimension getPreferredSize() {
        int lines = Math.max(1, (octets.length() + perLine() - 1) / perLine());
        return new Dimension(widthOf(LEAST_PER_LINE), lines * Theme.px(LINE_UNITS) + 2 * Theme.px(MARGIN_UNITS));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        g.setColor(Theme.color(Ink.CARD));
        g.fillRect(0, 0, getWidth(), getHeight());
        int perLine = perLine();
        for (int octet = 0; octet < octets.length(); octet++) {
            Rectangle place = placeOf(octet);
            boolean isMarked = marked.get(octet);
            double baseline = place.getCenterY() + Drawing.capHeight(g, Theme.mono()) / 2;
            if (octet % perLine == 0) {
                g.setFont(Theme.mono());
                g.setColor(Theme.color(Ink.QUIET));
                g.drawString("%04x".formatted(octet), Theme.exact(MARGIN_UNITS), (float) baseline);
            }
            paintOctet(g, octet, place, isMarked, perLine);
            Font font = isMarked ? Theme.monoStrong() : Theme.mono();
            g.setFont(font);
            g.setColor(Theme.color(isMarked ? Ink.ACCENT : Ink.TEXT));
            g.drawString(digits(octet), place.x, (float) baseline);
        }
    }

    private String digits(int octet) {
        return HexFormat.of().toHexDigits((byte) octets.octet(octet));
    }

    /** Extends the mark to the next octet of the same field. */
    private void paintOctet(Graphics2D g, int octet, Rectangle place, boolean isMarked, int perLine) {
        if (isMarked) {
            boolean goesOn = marked.get(octet + 1) && (octet + 1) % perLine != 0;
            double wide = place.width + (goesOn ? letter() : letter() / 2);
            g.setColor(Theme.color(Ink.ACCENT_WASH));
            Drawing.fillCrisp(g, place.x - letter() / 4, place.y + 1, wide + letter() / 4, place.height - 2);
        }
        if (octet == cursor) {
            g.setColor(Theme.color(Ink.ACCENT));
            g.setStroke(Theme.hairline());
            g.draw(Drawing.round(
                    place.x - letter() / 4, place.y + 1, place.width + letter() / 2, place.height - 2, Theme.exact(3)));
        }
    }

    @Override
    protected String spoken() {
        String of = cursor < 0
                ? texts.of("window.ladder.octets", octets.length())
                : texts.of("window.ladder.octet", cursor, digits(cursor));
        return field.isEmpty() ? of : of + ", " + field;
    }
}
