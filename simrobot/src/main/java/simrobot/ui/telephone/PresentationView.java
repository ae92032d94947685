package simrobot.ui.telephone;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;
import simgsm.dtmf.DtmfKey;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simrobot.ui.TelephoneSnapshot;
import vericommand.OrderCourse;
import vericommand.VeriCommandSnapshot;

/**
 * The current activity in one line, legible from the last row of a class: the sounding key with its two frequencies,
 * the order in words, its outcome.
 */
public final class PresentationView extends PaintedComponent {
    private static final double HEIGHT_UNITS = 96;
    private static final double KEY_POINTS = 56;
    private static final double TEXT_POINTS = 28;
    private static final double MARGIN_UNITS = 24;
    private static final double GAP_UNITS = 16;
    /** Minimum scale of the texts before the order wraps to a second row. */
    private static final double LEAST_SCALE = 0.75;

    private final Locale language;
    private String key = "";
    private String tones = "";
    private String course = "";
    private boolean isSounding;

    public PresentationView(Locale language) {
        super(AccessibleRole.LABEL);
        this.language = language;
        setName("presentation");
    }

    public void show(TelephoneSnapshot line) {
        String newKey = line.heard()
                .modem()
                .digit()
                .map(digit -> String.valueOf(digit.key().symbol()))
                .orElse("");
        String newTones =
                line.heard().modem().digit().map(digit -> hertz(digit.key())).orElse("");
        String newCourse = course(line.orders());
        boolean nowSounding = line.heard().modem().isSounding();
        if (!newKey.equals(key) || !newCourse.equals(course) || nowSounding != isSounding) {
            change(() -> {
                key = newKey;
                tones = newTones;
                course = newCourse;
            });
            isSounding = nowSounding;
            repaint();
        }
    }

    private static String hertz(DtmfKey key) {
        return Math.round(key.rowHertz()) + " + " + Math.round(key.columnHertz()) + " Hz";
    }

    /** The order and its outcome, as {@code forward 20 cm - 3 executed}. */
    private String course(VeriCommandSnapshot order) {
        String words = order.words().in(language);
        String ordered = words.isEmpty() ? order.keys() : words;
        String outcome =
                order.course() == OrderCourse.NONE ? order.verdictText().in(language) : outcome(order.course());
        return Stream.of(ordered, outcome).filter(text -> !text.isEmpty()).collect(Collectors.joining("  \u2013  "));
    }

    private String outcome(OrderCourse course) {
        return course.tone().map(tone -> tone.key() + " ").orElse("") + course.words(language);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, Theme.px(HEIGHT_UNITS));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double room = width - 2 * Theme.exact(MARGIN_UNITS);
        double scale = Math.min(1, room / fullWidth());
        if (scale >= LEAST_SCALE) {
            double x = paintKey(g, scale, height / 2, width);
            draw(g, Theme.sans(TEXT_POINTS * scale, true), course, x, height / 2, width);
        } else {
            paintKey(g, LEAST_SCALE, height * 0.28, width);
            double points = TEXT_POINTS * Math.min(1, room / courseWidth());
            draw(g, Theme.sans(points, true), course, Theme.exact(MARGIN_UNITS), height * 0.75, width);
        }
    }

    /** @return left edge of the next text */
    private double paintKey(Graphics2D g, double scale, double middle, double width) {
        g.setColor(Theme.color(isSounding ? Ink.ACCENT : Ink.TEXT));
        double x = draw(g, Theme.mono(KEY_POINTS * scale, true), key, Theme.exact(MARGIN_UNITS), middle, width);
        g.setColor(Theme.color(Ink.TEXT));
        return draw(g, Theme.mono(TEXT_POINTS * scale, false), tones, x, middle, width);
    }

    private double courseWidth() {
        return Drawing.width(Theme.sans(TEXT_POINTS, true), course) + Theme.exact(GAP_UNITS);
    }

    private double fullWidth() {
        return Drawing.width(Theme.mono(KEY_POINTS, true), key)
                + Drawing.width(Theme.mono(TEXT_POINTS, false), tones)
                + courseWidth()
                + 2 * Theme.exact(GAP_UNITS);
    }

    /** @return left edge of the next text */
    private static double draw(Graphics2D g, Font font, String text, double x, double middle, double width) {
        if (text.isEmpty()) {
            return x;
        }
        String fitted = Drawing.fitted(font, text, width - x - Theme.exact(MARGIN_UNITS));
        g.setFont(font);
        g.drawString(fitted, (float) x, (float) (middle + Drawing.capHeight(g, font) / 2));
        return x + Drawing.width(font, fitted) + Theme.exact(GAP_UNITS);
    }

    @Override
    protected String spoken() {
        return Stream.of(key, tones, course).filter(text -> !text.isEmpty()).collect(Collectors.joining(", "));
    }
}
