package simgsm.modem;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.words.Prompts;

/** The words of a modem's calls in both directions: replies that are said, and orders by voice. A core, as both are. */
public final class CallWords {
    /** Neither says nor hears anything. */
    public static final CallWords NONE = new CallWords(Optional.empty(), Optional.empty(), event -> {});

    private final Optional<WordPlayer> words;
    private final Optional<VoiceDialogue> voice;

    /**
     * @param prompts as in {@link ModemOptions}
     * @param voices as in {@link ModemOptions}
     * @param listener receives {@link ModemEvent.WordsBegun}, {@link ModemEvent.WordHeard} and {@link
     *     ModemEvent.OrderSpoken}
     */
    public CallWords(Optional<Prompts> prompts, Optional<VoiceStore> voices, Consumer<ModemEvent> listener) {
        words = prompts.map(spoken -> new WordPlayer(spoken, text -> listener.accept(new ModemEvent.WordsBegun(text))));
        voice = voices.map(store ->
                new VoiceDialogue(words.orElseThrow(), prompts.orElseThrow().language(), store, listener));
    }

    /** @return false without prompts */
    public boolean say(String reply) {
        words.ifPresent(player -> player.say(reply));
        return words.isPresent();
    }

    /** True if orders are taken by voice; callable on any thread. */
    public boolean listensToVoice() {
        return voice.isPresent();
    }

    /** Listens for one order. @param caller empty if unknown: the voice is not kept */
    public void listen(Optional<Msisdn> caller) {
        voice.ifPresent(dialogue -> dialogue.open(caller.map(Msisdn::digits).orElse("")));
    }

    /** True while an order by voice, or a word of an enrolment, is awaited. */
    public boolean isListening() {
        return voice.filter(VoiceDialogue::isOpen).isPresent();
    }

    /** A key ends the words. @return true if it confirms an order by voice and is no key of its own */
    public boolean key(DtmfKey key) {
        stop();
        return voice.isPresent() && voice.get().key(key);
    }

    /** Ends the words, as a tone follows. */
    public void stop() {
        words.ifPresent(WordPlayer::stop);
    }

    /** The call has ended. */
    public void end() {
        stop();
        voice.ifPresent(VoiceDialogue::close);
    }

    /** Speech of the caller. */
    public void hear(short[] samples) {
        voice.ifPresent(dialogue -> dialogue.hear(samples));
    }

    /** Fills the next frame for the caller unless a tone does. */
    public void read(short[] frame, boolean isTone) {
        words.ifPresent(player -> player.read(frame, isTone));
    }
}
