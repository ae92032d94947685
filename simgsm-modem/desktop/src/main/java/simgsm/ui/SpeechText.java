package simgsm.ui;

import java.util.Locale;
import java.util.Optional;
import simgsm.speech.SpeechCodec;

/** How a call's speech is coded, in a word or two. */
public final class SpeechText {
    private SpeechText() {}

    /**
     * As "A-law", or "GSM 06.10 out, A-law in" where the two ends have chosen differently.
     *
     * @param heard empty while nothing has come
     */
    public static String of(SpeechCodec.Kind sent, Optional<SpeechCodec.Kind> heard, Locale language) {
        Texts texts = DesktopTexts.in(language);
        String own = name(texts, sent);
        return heard.isEmpty() || heard.get() == sent
                ? own
                : texts.of("codec.different", own, name(texts, heard.get()));
    }

    private static String name(Texts texts, SpeechCodec.Kind kind) {
        return texts.of("codec." + kind.name().toLowerCase(Locale.ROOT));
    }
}
