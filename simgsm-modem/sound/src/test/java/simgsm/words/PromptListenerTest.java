package simgsm.words;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.speech.SpeechCodec;

class PromptListenerTest {
    private final List<String> heard = new ArrayList<>();
    private final PromptListener listener = new PromptListener(sentence -> heard.add(sentence.text()));

    @BeforeAll
    static void load() {
        PromptListener.load();
    }

    private static final List<String> ENGLISH = List.of(
            "Done: #**20. Stopped at 1.230 -0.500 m, heading 90.0.",
            "Collision after 12 of 20 cm, instruction 1 of 3.",
            "Not a valid command: * or # or digit expected at key 4. No key for 10 s.",
            "Not possible: no motors. Battery low.");
    private static final List<String> SPANISH = List.of(
            "Hecho: #**20. Parado en 21.070 0.500 m, rumbo 259.4.",
            "Choque tras 12 de 921 cm, paso 1 de 3.",
            "La orden no vale: se espera un valor en la tecla 6. Van 10 s sin teclas.");

    private void send(SpokenLanguage language, String reply, SpeechCodec.Kind... path) {
        Prompts prompts = Prompts.of(language);
        short[] words = prompts.samples(new SpokenReply(prompts).read(reply));
        short[] all = Arrays.copyOf(words, words.length + 160 * 40);
        SpeechCodec[] there = Arrays.stream(path).map(SpeechCodec.Kind::open).toArray(SpeechCodec[]::new);
        SpeechCodec[] here = Arrays.stream(path).map(SpeechCodec.Kind::open).toArray(SpeechCodec[]::new);
        for (int at = 0; at < all.length; at += 160) {
            short[] frame = Arrays.copyOfRange(all, at, at + 160);
            for (int i = 0; i < path.length; i++) {
                frame = here[i].decode(there[i].encode(frame));
            }
            listener.accept(frame);
        }
    }

    @ParameterizedTest
    @EnumSource(SpeechCodec.Kind.class)
    void sentencesOfBothLanguagesAreReadThroughEachCodec(SpeechCodec.Kind codec) {
        List<String> said = new ArrayList<>();
        for (SpokenLanguage language : SpokenLanguage.values()) {
            for (String reply : language == SpokenLanguage.ENGLISH ? ENGLISH : SPANISH) {
                said.add(new SpokenReply(Prompts.of(language)).read(reply).text());
                send(language, reply, codec);
            }
        }
        assertEquals(said, heard);
    }

    @Test
    void noiseAndTonesAreNoWords() {
        Random random = new Random(1);
        for (int i = 0; i < 500; i++) {
            short[] frame = new short[160];
            for (int k = 0; k < 160; k++) {
                frame[k] = (short) (random.nextGaussian() * 500 + 5000 * Math.sin(2 * Math.PI * 941 * k / 8000));
            }
            listener.accept(frame);
        }
        for (int i = 0; i < 30; i++) {
            listener.accept(new short[160]);
        }
        assertEquals(List.of(), heard);
    }
}
