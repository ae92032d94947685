package simgsm.phone.ui;

import java.util.Locale;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.console.TextBundle;
import simgsm.phone.screen.Screen;
import simgsm.phone.store.StoredMessage;
import simgsm.ss.SsError;

/** Cause texts: from the bundle, or else the title in the standard. */
final class CauseText {
    private CauseText() {}

    /** The reason for the end of a call. */
    static String of(TextBundle texts, Cause cause) {
        return of(texts, cause.code(), cause.title(texts.language()));
    }

    /** The reason why a message was not sent. */
    static String of(TextBundle texts, RpCause cause) {
        return of(texts, cause.code(), cause.title(texts.language()));
    }

    /** A notice for the user. */
    static String ofNote(TextBundle texts, Screen.Note note) {
        String detail = note.detail();
        if (note.kind() == Screen.Note.Kind.USSD_REFUSED && !detail.isEmpty()) {
            int code = Integer.parseInt(detail);
            detail = of(
                    texts,
                    "ss.",
                    code,
                    SsError.ofCode(code)
                            .map(error -> error.title(texts.language()))
                            .orElse(""));
        }
        return texts.of("note." + note.kind().name().toLowerCase(Locale.ROOT), detail);
    }

    /** The reason for the rejection of a registration. */
    static String ofRefusal(TextBundle texts, RejectCause cause, boolean cardRefused, Msisdn own) {
        if (cardRefused) {
            return texts.of("lcd.refused.card");
        }
        return switch (cause) {
            // The centre answers "illegal MS" to a second phone with a number in use.
            case ILLEGAL_MS -> texts.of("lcd.refused.taken", own.digits());
            case IMSI_UNKNOWN_IN_HLR -> texts.of("lcd.refused.unknown");
            case ILLEGAL_ME -> texts.of("lcd.refused.equipment");
            case PLMN_NOT_ALLOWED -> texts.of("lcd.refused.barred");
            default -> texts.of("lcd.refused", cause.title(texts.language()));
        };
    }

    /** The delivery state of a sent message, with the cause of a failure. */
    static String ofDelivery(TextBundle texts, StoredMessage message) {
        String state = texts.of("lcd.delivery." + message.delivery().name().toLowerCase(Locale.ROOT), message.parts());
        return message.cause()
                .map(cause -> state + ": " + of(texts, cause.code(), cause.title(texts.language())))
                .orElse(state);
    }

    private static String of(TextBundle texts, int code, String title) {
        return of(texts, "cause.", code, title);
    }

    private static String of(TextBundle texts, String family, int code, String title) {
        String key = family + code;
        String words = texts.of(key);
        return words.equals(key) ? title + " (" + code + ")" : words;
    }
}
