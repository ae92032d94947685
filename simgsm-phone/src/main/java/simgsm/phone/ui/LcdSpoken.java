package simgsm.phone.ui;

import java.util.List;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.phone.handset.CallPhase;
import simgsm.phone.handset.CallSnapshot;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.handset.MenuItem;
import simgsm.phone.handset.MessageFolder;
import simgsm.phone.handset.Screen;
import simgsm.phone.handset.StoredMessage;
import simgsm.phone.handset.ToneMeaning;

/** The display's content as a sentence for assistive technology. */
final class LcdSpoken {
    private final TextBundle texts;

    LcdSpoken(TextBundle texts) {
        this.texts = texts;
    }

    String of(HandsetSnapshot phone) {
        Screen screen = phone.screen();
        if (!phone.station().powered()) {
            return texts.of("lcd.off");
        }
        if (screen instanceof Screen.Menu menu) {
            return name("menu.", MenuItem.values()[menu.selected()]);
        }
        if (screen instanceof Screen.MessageList list) {
            return message(phone, list.box(), list.selected());
        }
        if (screen instanceof Screen.MessageView view) {
            return message(phone, view.box(), view.selected());
        }
        if (screen instanceof Screen.Writing writing) {
            return texts.of("menu.write") + ": " + writing.text();
        }
        if (screen instanceof Screen.Recipient recipient) {
            return texts.of("lcd.to") + " " + recipient.number();
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
            return texts.of("note." + note.kind().name().toLowerCase(Locale.ROOT), note.detail());
        }
        return home(phone);
    }

    private String name(String family, Enum<?> item) {
        return texts.of(family + item.name().toLowerCase(Locale.ROOT));
    }

    private String message(HandsetSnapshot phone, MessageFolder box, int selected) {
        List<StoredMessage> messages = phone.in(box);
        int index = messages.size() - 1 - selected;
        String title = name("menu.", box);
        return index < 0
                ? title + ": " + texts.of("lcd.empty")
                : title + ": " + messages.get(index).party() + ", "
                        + messages.get(index).text();
    }

    private String news(HandsetSnapshot phone) {
        String messages = phone.unread() > 0 ? ", " + texts.of("lcd.unread", phone.unread()) : "";
        int broadcasts = phone.unread(MessageFolder.BROADCASTS);
        return broadcasts > 0 ? messages + ", " + texts.of("lcd.unread.broadcasts", broadcasts) : messages;
    }

    private String home(HandsetSnapshot phone) {
        CallSnapshot call = phone.call();
        if (call.phase() == CallPhase.NONE) {
            return phone.typed().isEmpty() ? texts.of("lcd.own") + " " + phone.own() + news(phone) : phone.typed();
        }
        String meaning = call.tone()
                .flatMap(ToneMeaning::textKey)
                .map(key -> " " + texts.of("lcd.meaning", texts.of(key)))
                .orElse("");
        String tone = call.tone().map(key -> ", " + key.symbol()).orElse("");
        return name("lcd.call.", call.phase()) + " " + call.number() + tone + meaning;
    }
}
