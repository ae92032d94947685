package simgsm.phone.screen;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import simgsm.draw.Appearance;
import simgsm.phone.screen.ListPage.ListItem;
import simgsm.speech.SpeechCodec;

/** The menu of settings; each opens a list of its values. */
final class SettingsPages {
    private final PageStack stack;
    private final Supplier<UserSettings> settings;

    SettingsPages(PageStack stack, Supplier<UserSettings> settings) {
        this.stack = stack;
        this.settings = settings;
    }

    KeyIntent menu() {
        List<SpeechCodec.Kind> codecs = List.of(SpeechCodec.Kind.A_LAW, SpeechCodec.Kind.GSM_FULL_RATE);
        return stack.open(ListPage.menu(
                stack,
                "menu.settings",
                () -> List.of(
                        language(),
                        choice("ring.", List.of(RingTone.values()), UserSettings::ringTone, UserSettings::withRingTone),
                        volume(),
                        choice(
                                "theme.",
                                List.of(Appearance.values()),
                                UserSettings::appearance,
                                UserSettings::withAppearance),
                        choice("codec.", codecs, UserSettings::codec, UserSettings::withCodec),
                        choice("keys.", List.of(KeyMode.values()), UserSettings::keyMode, UserSettings::withKeyMode),
                        choice(
                                "length.",
                                List.of(ToneLength.values()),
                                UserSettings::toneLength,
                                UserSettings::withToneLength))));
    }

    private ListItem language() {
        Function<String, Words> words = code -> Words.of("language." + code);
        return setting(
                "setting.language", List.of("en", "es"), UserSettings::language, words, UserSettings::withLanguage);
    }

    private ListItem volume() {
        List<Integer> values =
                IntStream.rangeClosed(0, UserSettings.MOST_VOLUME).boxed().toList();
        Function<Integer, Words> words = volume -> Words.plain(String.valueOf(volume));
        return setting("setting.volume", values, UserSettings::volume, words, UserSettings::withVolume);
    }

    /** @param family prefix of the values' text keys */
    private <T extends Enum<T>> ListItem choice(
            String family, List<T> values, Function<UserSettings, T> value, Change<T> change) {
        return setting("setting." + family.replace(".", ""), values, value, each -> named(family, each), change);
    }

    private static Words named(String family, Enum<?> value) {
        return Words.of(family + value.name().toLowerCase(Locale.ROOT));
    }

    /** Sets one setting to a value. */
    private interface Change<T> {
        UserSettings of(UserSettings before, T value);
    }

    private <T> ListItem setting(
            String title, List<T> values, Function<UserSettings, T> value, Function<T, Words> words, Change<T> change) {
        return ListItem.of(
                Screen.Row.of(Words.of(title), words.apply(value.apply(settings.get()))),
                () -> choose(title, values, value, words, chosen -> before -> change.of(before, chosen)));
    }

    private <T> KeyIntent choose(
            String title,
            List<T> values,
            Function<UserSettings, T> value,
            Function<T, Words> words,
            Function<T, UnaryOperator<UserSettings>> change) {
        List<ListItem> items = new ArrayList<>();
        ListPage page = new ListPage(stack, Words.of(title), true, () -> items);
        T now = value.apply(settings.get());
        for (T each : values) {
            Screen.Mark mark = each.equals(now) ? Screen.Mark.CHOSEN : Screen.Mark.NOT_CHOSEN;
            items.add(ListItem.of(Screen.Row.of(mark, words.apply(each)), () -> {
                stack.close(page);
                return new KeyIntent.ChangeSettings(change.apply(each).apply(settings.get()));
            }));
        }
        return stack.open(page.selecting(values.indexOf(now)));
    }
}
