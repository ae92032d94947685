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

/** The menu of settings; each opens its values, of which one is chosen. */
final class SettingsPages {
    private final PageStack stack;
    private final Supplier<UserSettings> settings;

    SettingsPages(PageStack stack, Supplier<UserSettings> settings) {
        this.stack = stack;
        this.settings = settings;
    }

    KeyIntent menu() {
        return stack.open(ListPage.menu(
                stack,
                "menu.settings",
                () -> List.of(
                        setting(
                                "setting.language",
                                List.of("en", "es"),
                                UserSettings::language,
                                code -> Words.of("language." + code),
                                UserSettings::withLanguage),
                        setting(
                                "setting.ring",
                                List.of(RingTone.values()),
                                UserSettings::ringTone,
                                tone -> named("ring.", tone),
                                UserSettings::withRingTone),
                        setting(
                                "setting.volume",
                                IntStream.rangeClosed(0, UserSettings.MOST_VOLUME)
                                        .boxed()
                                        .toList(),
                                UserSettings::volume,
                                volume -> Words.plain(String.valueOf(volume)),
                                UserSettings::withVolume),
                        setting(
                                "setting.theme",
                                List.of(Appearance.values()),
                                UserSettings::appearance,
                                theme -> named("theme.", theme),
                                UserSettings::withAppearance),
                        setting(
                                "setting.codec",
                                List.of(SpeechCodec.Kind.A_LAW, SpeechCodec.Kind.GSM_FULL_RATE),
                                UserSettings::codec,
                                codec -> named("codec.", codec),
                                UserSettings::withCodec),
                        setting(
                                "setting.keys",
                                List.of(KeyMode.values()),
                                UserSettings::keyMode,
                                mode -> named("keys.", mode),
                                UserSettings::withKeyMode),
                        setting(
                                "setting.length",
                                List.of(ToneLength.values()),
                                UserSettings::toneLength,
                                length -> named("length.", length),
                                UserSettings::withToneLength))));
    }

    private static Words named(String family, Enum<?> value) {
        return Words.of(family + value.name().toLowerCase(Locale.ROOT));
    }

    /** Gives the settings another value. */
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
