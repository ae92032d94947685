package simgsm.ui.scope;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.dtmf.KeyCandidate;
import simgsm.scope.ReceiverTrace;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/**
 * The newest candidate keys of one receiver: a bar each that climbs to the dashed line of the decision, and the newest one's
 * finding in words.
 *
 * <pre>
 *   - - -#- - - - #   5: log odds 1.2 of 3.5,
 *      # # #   #  #   another tone at -4.0 dB
 *      1 5 5   2  5
 * </pre>
 */
final class CandidateLane extends PaintedComponent {
    /** Units. */
    private static final int HEIGHT = 38;

    private static final double STEP = 13;
    private static final double LABEL = 11;
    /** Part of the width with bars. */
    private static final double BARS = 0.42;
    /** Height of the decision's line, relative to the bars. */
    private static final double LINE = 0.75;

    private final TextBundle texts;
    private List<KeyCandidate> candidates = List.of();

    CandidateLane(Locale language, ShownReceiver receiver) {
        super(AccessibleRole.CANVAS);
        texts = DesktopTexts.in(language);
        makeFocusable();
        setName("scope.candidates." + receiver.name().toLowerCase(Locale.ROOT));
    }

    void show(ReceiverTrace trace) {
        if (!trace.candidates().equals(candidates)) {
            change(() -> candidates = trace.candidates());
            setToolTipText(spoken());
            repaint();
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(160), Theme.px(HEIGHT));
    }

    @Override
    protected String spoken() {
        return candidates.isEmpty()
                ? texts.of("scope.candidates.none")
                : CandidateWords.of(texts, candidates.get(candidates.size() - 1));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double step = Theme.exact(STEP);
        int places = Math.max(1, Math.min(ReceiverTrace.MOST_CANDIDATES, (int) (width * BARS / step)));
        double bars = places * step;
        double tall = height - Theme.exact(LABEL);
        List<KeyCandidate> shown = candidates.subList(Math.max(0, candidates.size() - places), candidates.size());
        for (int i = 0; i < shown.size(); i++) {
            paintBar(g, shown.get(i), i * step, tall, step);
        }
        g.setColor(Theme.color(Ink.LINE));
        Drawing.horizontal(g, 0, bars, tall);
        g.setColor(Theme.color(Ink.DANGER));
        g.setStroke(Theme.dashed(1.3, 4));
        Drawing.line(g, 0, tall * (1 - LINE), bars, tall * (1 - LINE));
        boolean accepted =
                !candidates.isEmpty() && candidates.get(candidates.size() - 1).isAccepted();
        g.setColor(Theme.color(accepted ? Ink.TEXT : Ink.QUIET));
        double left = bars + Theme.exact(Theme.GRID);
        paintWords(g, left, width - left, height);
    }

    private static void paintBar(Graphics2D g, KeyCandidate candidate, double x, double tall, double step) {
        boolean accepted = candidate.isAccepted();
        double high = tall * Math.min(1, LINE * candidate.climbed());
        g.setColor(Theme.color(Ink.LINE, 0.45));
        Drawing.fillCrisp(g, x + step * 0.16, 0, step * 0.68, tall);
        g.setColor(Theme.color(accepted ? Ink.ACCENT : Ink.QUIET));
        Drawing.fillCrisp(g, x + step * 0.16, tall - high, step * 0.68, high);
        g.setColor(Theme.color(accepted ? Ink.TEXT : Ink.QUIET));
        String symbol = String.valueOf(candidate.key().symbol());
        Drawing.centred(g, symbol, Theme.mono(9.5, accepted), x + step / 2, tall + Theme.exact(LABEL) * 0.55);
    }

    /** As many lines as fit; the last is cut. */
    private void paintWords(Graphics2D g, double x, double width, double height) {
        var font = Theme.small();
        g.setFont(font);
        double line = g.getFontMetrics().getHeight();
        int most = Math.max(1, (int) (height / line));
        List<String> lines = Drawing.wrapped(font, spoken(), width, most);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), (float) x, (float) (line * (i + 0.8)));
        }
    }
}
