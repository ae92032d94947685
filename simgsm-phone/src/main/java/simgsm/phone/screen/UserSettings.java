package simgsm.phone.screen;

import simgsm.draw.Appearance;
import simgsm.speech.SpeechCodec;

/**
 * What the user has set.
 *
 * @param language of the display: "en" or "es"
 * @param volume of the earpiece, 0 to {@link #MOST_VOLUME}
 * @param codec of the speech sent, from the next call on
 * @param keyMode from the next call on
 */
public record UserSettings(
        String language,
        Appearance appearance,
        int volume,
        RingTone ringTone,
        SpeechCodec.Kind codec,
        KeyMode keyMode,
        ToneLength toneLength) {
    public static final int MOST_VOLUME = 7;

    public UserSettings {
        if (volume < 0 || volume > MOST_VOLUME) {
            throw new IllegalArgumentException("volume " + volume + ": expected 0 to " + MOST_VOLUME);
        }
    }

    /** As the phone is delivered, with these ways of speech and keys. */
    public static UserSettings delivered(SpeechCodec.Kind codec, KeyMode keyMode) {
        return new UserSettings("en", Appearance.LIGHT, MOST_VOLUME, RingTone.WARBLE, codec, keyMode, ToneLength.HELD);
    }

    public UserSettings withLanguage(String newLanguage) {
        return new UserSettings(newLanguage, appearance, volume, ringTone, codec, keyMode, toneLength);
    }

    public UserSettings withAppearance(Appearance newAppearance) {
        return new UserSettings(language, newAppearance, volume, ringTone, codec, keyMode, toneLength);
    }

    /** @param newVolume limited to its bounds */
    public UserSettings withVolume(int newVolume) {
        int bounded = Math.max(0, Math.min(MOST_VOLUME, newVolume));
        return new UserSettings(language, appearance, bounded, ringTone, codec, keyMode, toneLength);
    }

    public UserSettings withRingTone(RingTone newRingTone) {
        return new UserSettings(language, appearance, volume, newRingTone, codec, keyMode, toneLength);
    }

    public UserSettings withCodec(SpeechCodec.Kind newCodec) {
        return new UserSettings(language, appearance, volume, ringTone, newCodec, keyMode, toneLength);
    }

    public UserSettings withKeyMode(KeyMode newKeyMode) {
        return new UserSettings(language, appearance, volume, ringTone, codec, newKeyMode, toneLength);
    }

    public UserSettings withToneLength(ToneLength newToneLength) {
        return new UserSettings(language, appearance, volume, ringTone, codec, keyMode, newToneLength);
    }
}
