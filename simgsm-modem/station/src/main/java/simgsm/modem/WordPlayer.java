package simgsm.modem;

import java.util.function.Consumer;
import simgsm.words.Prompts;
import simgsm.words.SpokenReply;
import simgsm.words.Utterance;

/**
 * Says replies in words, 200 ms after the last reply tone, in whole frames of the prompts; a tone or a key ends them. A
 * core with the time of the frames sent.
 */
final class WordPlayer {
    private static final int SAMPLES_PER_FRAME = 160;
    /** 200 ms. */
    static final int PAUSE_FRAMES = 10;

    private final Prompts prompts;
    private final SpokenReply reader;
    private final Consumer<String> begun;
    private short[] samples = new short[0];
    private String text = "";
    private int silentFrames;
    private int at;

    /** @param begun receives the words with their first frame */
    WordPlayer(Prompts prompts, Consumer<String> begun) {
        this.prompts = prompts;
        this.begun = begun;
        reader = new SpokenReply(prompts);
    }

    /** Replaces the present words. */
    void say(String reply) {
        say(reader.read(reply));
    }

    void say(Utterance utterance) {
        samples = prompts.samples(utterance);
        text = utterance.text();
        at = 0;
    }

    void stop() {
        samples = new short[0];
        at = 0;
    }

    /** True until the last word has been sent. */
    boolean isSpeaking() {
        return at < samples.length;
    }

    /** Fills a frame unless a tone does. @param isTone true if the frame has a tone */
    void read(short[] frame, boolean isTone) {
        silentFrames = isTone ? 0 : silentFrames + 1;
        if (!isSpeaking() || silentFrames <= PAUSE_FRAMES) {
            return;
        }
        if (at == 0) {
            begun.accept(text);
        }
        System.arraycopy(samples, at, frame, 0, SAMPLES_PER_FRAME);
        at += SAMPLES_PER_FRAME;
    }
}
