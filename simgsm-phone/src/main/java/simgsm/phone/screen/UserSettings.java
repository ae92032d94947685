package simgsm.phone.screen;

import java.util.Map;
import simgsm.draw.Appearance;
import simgsm.speech.SpeechCodec;

/**
 * The user's settings.
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

    /** Keys of {@link #texts}. */
    public static final String CODEC = "setting.codec";

    public static final String KEYS = "setting.keys";

    public UserSettings {
        if (volume < 0 || volume > MOST_VOLUME) {
            throw new IllegalArgumentException("volume " + volume + ": expected 0 to " + MOST_VOLUME);
        }
    }

    /** The factory settings with this codec and key mode. */
    public static UserSettings delivered(SpeechCodec.Kind codec, KeyMode keyMode) {
        return new UserSettings("en", Appearance.LIGHT, MOST_VOLUME, RingTone.WARBLE, codec, keyMode, ToneLength.HELD);
    }

    /** The settings as texts by key, for the next run; the window keeps language and colours. */
    public Map<String, String> texts() {
        return Map.of(
                "setting.volume",
                String.valueOf(volume),
                "setting.ring",
                ringTone.name(),
                CODEC,
                codec.name(),
                KEYS,
                keyMode.name(),
                "setting.length",
                toneLength.name());
    }

    /** Replaces settings by those of an earlier run. @throws IllegalArgumentException for an invalid value */
    public UserSettings restored(Map<String, String> texts) {
        UserSettings next = this;
        for (Map.Entry<String, String> text : texts.entrySet()) {
            String value = text.getValue();
            next = switch (text.getKey()) {
                case "setting.volume" -> next.withVolume(Integer.parseInt(value));
                case "setting.ring" -> next.withRingTone(RingTone.valueOf(value));
                case CODEC -> next.withCodec(SpeechCodec.Kind.valueOf(value));
                case KEYS -> next.withKeyMode(KeyMode.valueOf(value));
                case "setting.length" -> next.withToneLength(ToneLength.valueOf(value));
                default -> next;
            };
        }
        return next;
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
