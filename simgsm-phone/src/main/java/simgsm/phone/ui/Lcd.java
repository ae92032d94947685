package simgsm.phone.ui;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.time.Clock;
import java.time.LocalTime;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.ui.Drawing;
import simgsm.ui.SpokenComponent;

/** The phone's display. */
final class Lcd extends SpokenComponent {
    private final LcdPainter painter;
    private final LcdSpoken spoken;
    private final Clock clock;
    private HandsetSnapshot phone;
    private int shownMinute = -1;

    Lcd(TextBundle texts, Locale language, Clock clock, HandsetSnapshot first) {
        super(AccessibleRole.LABEL);
        this.spoken = new LcdSpoken(texts);
        this.painter = new LcdPainter(texts, language, clock.getZone());
        this.clock = clock;
        this.phone = first;
        setName("lcd");
    }

    void show(HandsetSnapshot snapshot) {
        String before = spoken();
        boolean sameLook = snapshot.screen().equals(phone.screen())
                && snapshot.call().equals(phone.call())
                && snapshot.typed().equals(phone.typed())
                && snapshot.station().equals(phone.station())
                && snapshot.inbox() == phone.inbox()
                && snapshot.outbox() == phone.outbox()
                && snapshot.broadcasts() == phone.broadcasts();
        phone = snapshot;
        if (!sameLook) {
            String after = spoken();
            tellSpoken(before, after);
            repaint();
        }
    }

    /** Paints anew when the minute has changed. */
    void lookAtClock() {
        if (LocalTime.now(clock).getMinute() != shownMinute) {
            repaint();
        }
    }

    @Override
    protected String spoken() {
        return spoken.of(phone);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            LocalTime now = LocalTime.now(clock);
            shownMinute = now.getMinute();
            painter.paint(g, phone, now, getWidth(), getHeight());
        } finally {
            g.dispose();
        }
    }
}
