package simgsm.phone.ui;

import java.awt.Graphics2D;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.SoftKeys;
import simgsm.phone.store.MessageFolder;
import simgsm.station.StationSnapshot;
import simgsm.ui.Drawing;
import simgsm.ui.SignalBars;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;

/** Paints the phone's display from a snapshot: the status line, then the screen. */
final class LcdPainter {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT);
    private static final double SOFT_BASELINE = 171;

    private final TextBundle texts;
    private final LcdHome home;
    private final LcdLists lists;
    private final LcdWriting writing;

    LcdPainter(TextBundle texts, Locale language, ZoneId zone) {
        this.texts = texts;
        this.home = new LcdHome(texts, language);
        WordsText words = new WordsText(texts, zone);
        this.lists = new LcdLists(texts, words);
        this.writing = new LcdWriting(texts, words);
    }

    /** Fills a box of that size at the origin. */
    void paint(Graphics2D g, HandsetSnapshot phone, LocalTime now, double width, double height) {
        double unit = Math.min(width / LcdPen.WIDTH, height / LcdPen.HEIGHT);
        g.setColor(Theme.color(Ink.LCD_RIM));
        g.fill(Drawing.round(0, 0, width, height, 10 * unit));
        g.setColor(Theme.color(Ink.LCD_PAPER));
        g.fill(Drawing.round(2.5 * unit, 2.5 * unit, width - 5 * unit, height - 5 * unit, 8 * unit));
        LcdPen pen = new LcdPen(g, unit);
        pen.ink(Ink.LCD_INK);
        if (!phone.station().powered()) {
            pen.ink(Ink.LCD_QUIET);
            pen.centred(texts.of("lcd.off"), pen.sans(14, false), 96);
            pen.centred(texts.of("lcd.off.hint"), pen.sans(11, false), 118);
            return;
        }
        statusLine(pen, phone, now);
        screen(pen, phone);
        softKeys(pen, phone.softKeys());
    }

    private void softKeys(LcdPen pen, SoftKeys keys) {
        pen.ink(Ink.LCD_INK);
        var font = pen.sans(12.5, true);
        String right = soft(keys.right());
        pen.left(soft(keys.left()), font, LcdPen.MARGIN, SOFT_BASELINE);
        pen.right(right, font, LcdPen.WIDTH - LcdPen.MARGIN, SOFT_BASELINE);
    }

    private String soft(String key) {
        return key.isEmpty() ? "" : texts.of(key);
    }

    private void statusLine(LcdPen pen, HandsetSnapshot phone, LocalTime now) {
        int level = phone.station().signalBars(SignalBars.BARS);
        SignalBars.paint(
                pen.graphics(),
                LcdPen.MARGIN * pen.unit(),
                11 * pen.unit(),
                24 * pen.unit(),
                13 * pen.unit(),
                level,
                Theme.color(Ink.LCD_INK),
                Theme.color(Ink.LCD_GHOST));
        pen.ink(Ink.LCD_INK);
        pen.left(serviceName(phone), pen.sans(12.5, true), 44, 24, 138);
        if (phone.unread() > 0) {
            pen.symbol(Symbol.ENVELOPE, 212, 18.5, 15);
        }
        if (phone.unread(MessageFolder.BROADCASTS) > 0) {
            pen.symbol(Symbol.BROADCAST, 193, 18.5, 15);
        }
        pen.right(CLOCK.format(now), pen.mono(13, true), LcdPen.WIDTH - LcdPen.MARGIN, 24);
        pen.ink(Ink.LCD_GHOST);
        pen.fill(LcdPen.MARGIN, 31, LcdPen.WIDTH - 2 * LcdPen.MARGIN, 1);
        pen.ink(Ink.LCD_INK);
    }

    private String serviceName(HandsetSnapshot phone) {
        var station = phone.station();
        if (station.registered()) {
            return operatorOf(station)
                    + station.cell().map(cell -> " " + cell.identity()).orElse("");
        }
        if (station.isEmergencyOnly()) {
            return texts.of("lcd.service.emergency");
        }
        return texts.of(station.rejectCause().isPresent() ? "lcd.service.refused" : "lcd.service.searching");
    }

    static String operatorOf(StationSnapshot station) {
        return station.networkName().isEmpty() ? "SIMGSM" : station.networkName();
    }

    private void screen(LcdPen pen, HandsetSnapshot phone) {
        Screen screen = phone.screen();
        if (screen instanceof Screen.Listing list) {
            lists.list(pen, list);
        } else if (screen instanceof Screen.MessageView view) {
            lists.message(pen, phone, view);
        } else if (screen instanceof Screen.Details details) {
            lists.details(pen, details);
        } else if (screen instanceof Screen.Writing text) {
            writing.text(pen, text);
        } else if (screen instanceof Screen.Entry entry) {
            writing.entry(pen, phone, entry);
        } else if (screen instanceof Screen.Sent sent) {
            writing.sent(pen, phone, sent.message());
        } else if (screen instanceof Screen.Ussd ussd) {
            writing.ussd(pen, ussd);
        } else if (screen instanceof Screen.Note note) {
            writing.note(pen, note);
        } else {
            home.paint(pen, phone);
        }
    }
}
