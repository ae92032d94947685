package simgsm.ui.scope;

import java.util.Locale;
import java.util.Optional;
import simgsm.console.TextBundle;
import simgsm.speech.SpeechCodec;
import simgsm.ui.DesktopTexts;

/** The name of a call's speech codec. */
public final class CodecText {
    private CodecText() {}

    /**
     * As "A-law", or "GSM 06.10 out, A-law in" when the two directions differ; empty if unknown.
     *
     * @param heard empty until speech has been received
     */
    public static String of(Optional<SpeechCodec.Kind> sent, Optional<SpeechCodec.Kind> heard, Locale language) {
        TextBundle texts = DesktopTexts.in(language);
        String own = sent.map(kind -> name(texts, kind)).orElse("");
        return heard.isEmpty() || heard.equals(sent) ? own : texts.of("codec.different", own, name(texts, heard.get()));
    }

    static String name(TextBundle texts, SpeechCodec.Kind kind) {
        return texts.of("codec." + kind.name().toLowerCase(Locale.ROOT));
    }
}
