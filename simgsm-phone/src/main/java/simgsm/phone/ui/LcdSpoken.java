package simgsm.phone.ui;

import java.util.stream.Collectors;
import simgsm.console.TextBundle;
import simgsm.phone.handset.CallSnapshot;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.screen.Screen;
import simgsm.phone.store.MessageFolder;
import simgsm.ui.SignalBars;

/** The display's content as a sentence for assistive technology. */
final class LcdSpoken {
    private final TextBundle texts;
    private final WordsText words;

    LcdSpoken(TextBundle texts, WordsText words) {
        this.texts = texts;
        this.words = words;
    }

    String of(HandsetSnapshot phone) {
        Screen screen = phone.screen();
        if (!phone.station().powered()) {
            return texts.of("lcd.off");
        }
        if (screen instanceof Screen.Listing list) {
            return list(list);
        }
        if (screen instanceof Screen.MessageView view) {
            return phone.nameOf(view.message().party()) + ", " + view.message().text();
        }
        if (screen instanceof Screen.Details details) {
            String lines = details.lines().stream().map(words::of).collect(Collectors.joining(", "));
            String title = words.of(details.title());
            return title.isEmpty() ? lines : title + ": " + lines;
        }
        if (screen instanceof Screen.Writing writing) {
            return texts.of("menu.write") + ": " + writing.text();
        }
        if (screen instanceof Screen.Entry entry) {
            String emergency = phone.station().card().isReady() ? "" : ", " + texts.of("lcd.hint.emergency");
            return words.of(entry.title()) + ": " + entry.text() + emergency;
        }
        if (screen instanceof Screen.Sent sent) {
            return CauseText.ofDelivery(texts, sent.message()) + news(phone);
        }
        if (screen instanceof Screen.Ussd ussd) {
            return ussd.phase() == Screen.Ussd.Phase.WAITING
                    ? texts.of("lcd.ussd.waiting", ussd.text())
                    : ussd.text() + " " + ussd.reply();
        }
        if (screen instanceof Screen.Note note) {
            return CauseText.ofNote(texts, note);
        }
        return home(phone);
    }

    /** The title and the selected row. */
    private String list(Screen.Listing list) {
        String title = words.of(list.title());
        if (list.rows().isEmpty()) {
            return title + ": " + texts.of("lcd.empty");
        }
        Screen.Row row = list.rows().get(list.selected());
        String mark = row.mark() == Screen.Mark.CHOSEN ? ", " + texts.of("lcd.chosen") : "";
        String note = words.of(row.note()).isEmpty() ? "" : ", " + words.of(row.note());
        String detail = row.detail().isEmpty() ? "" : ", " + row.detail();
        return title + ": " + words.of(row.label()) + note + detail + mark;
    }

    private String news(HandsetSnapshot phone) {
        String messages = phone.unread() > 0 ? ", " + texts.of("lcd.unread", phone.unread()) : "";
        messages += phone.missed() > 0 ? ", " + texts.of("lcd.missed", phone.missed()) : "";
        int broadcasts = phone.unread(MessageFolder.BROADCASTS);
        return broadcasts > 0 ? messages + ", " + texts.of("lcd.unread.broadcasts", broadcasts) : messages;
    }

    private String home(HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        if (call.phase() == CallPhase.NONE
                && call.held().isPresent()
                && phone.typed().isEmpty()) {
            return texts.of("lcd.held", phone.nameOf(call.held().get()));
        }
        if (call.phase() == CallPhase.NONE) {
            String signal = texts.of("lcd.signal", phone.station().signalBars(SignalBars.BARS), SignalBars.BARS);
            return phone.typed().isEmpty()
                    ? texts.of("lcd.own") + " " + phone.own() + ", " + signal + news(phone)
                    : phone.typed();
        }
        String meaning = call.tone()
                .flatMap(call::meaningOf)
                .map(key -> " (" + texts.of("lcd.meaning", texts.of(key)) + ")")
                .orElse("");
        String tone = call.tone().map(key -> ", " + key.symbol()).orElse("");
        String said = call.words().isEmpty() ? "" : ", " + call.words();
        String waiting = call.waiting()
                .map(number -> ", " + texts.of("lcd.waiting", phone.nameOf(number)))
                .orElse("");
        String held = call.held()
                .map(number -> ", " + texts.of("lcd.held", phone.nameOf(number)))
                .orElse("");
        return LcdCall.phaseOf(texts, call) + " " + phone.nameOf(call.number()) + tone + meaning + said + waiting
                + held;
    }
}
