// SPDX-License-Identifier: MIT
// The loop that all questions share: draw cases, pass them to graze, judge and count the answers, and pass the cases to
// rivals. A question is a class such as those in *_question.hpp, with these members:
//
//   static constexpr std::string_view name;                its name in the data file
//   static constexpr SpaceName space;
//   static constexpr std::size_t Settings::* limit;        the number of cases
//   static constexpr std::uint64_t seeds_apart;            makes cases of different questions differ
//   static constexpr std::size_t variations;               of each case drawn, for graze alone
//   static constexpr bool has_rivals;
//   static std::vector<Subject> subjects();                what the question is about
//   Question(const Subject&, std::uint64_t seed);
//   using Case, Truth                                      what is drawn, and the oracle's answer to it
//   std::vector<Case> draw(std::size_t turn);              one case, or a few that belong together
//   Case vary(const Case&);                                if there are variations
//   Judged<Truth> judge(const Case&, Figures&);            queries graze and the oracle, and records graze's errors
//   static std::string row(const Case&, const Truth&);     the regression row of a case that failed
//
// and, if there are rivals, these:
//
//   using Asked                                            a case with what is needed to judge answers to it
//   static const Rival<...> rivals[];
//   std::optional<Asked> asked(const Case&, const Truth&); none if the case is not fair to rivals
//   static std::optional<Answer> ask(const Rival&, const Asked&);
//   static Answer own_answer(const Asked&);                graze's
//   static void mark(const Asked&, const Answer&, Figures&);  counts the errors of an answer
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exam/settings.hpp"
#include "exam/tally.hpp"
#include "query/verdict_band.hpp"

namespace graze::exam {

/// The subject of a question: two types, one type, or a kind of points.
struct Subject {
  std::size_t a = 0;  ///< Indices of types in AnyShape, or of a kind.
  std::size_t b = 0;
  std::string name;        ///< "obb, triangle".
  std::string task;        ///< "obb, triangle at a distance".
  std::uint64_t seed = 0;  ///< Makes cases of different subjects differ.
};

template <class Truth>
struct Judged {
  Truth truth;
  test::Judgement judgement;
  double hardness = 0;  ///< How close the case is to a failure; 0 if unknown.
};

/// One question about one subject, in one space.
struct Task {
  std::string name;  ///< "3D float obb, triangle at a distance".
  std::function<Tally()> run;
};

template <class Question>
class Exam {
 public:
  using Case = typename Question::Case;
  using Truth = typename Question::Truth;

  Exam(const Subject& subject, const Settings& settings, RegressionLog& regressions)
      : settings_(settings),
        regressions_(regressions),
        question_(subject, settings.seed * Question::seeds_apart + subject.seed),
        tally_{Question::name, Question::space, subject.name, {}, {}} {}

  Tally run() {
    for (std::size_t turn = 0; tally_.own.cases < settings_.*Question::limit && has_time(); ++turn) {
      for (const Case& drawn : question_.draw(turn)) {
        const Truth truth = put(drawn);
        if constexpr (Question::has_rivals) put_to_rivals(drawn, truth);
        if constexpr (Question::variations > 0) {
          for (std::size_t i = 0; i < Question::variations; ++i) put(question_.vary(drawn));
        }
      }
    }
    if (settings_.keeps_hardest && !hardest_.empty()) regressions_.add(hardest_);
    return std::move(tally_);
  }

 private:
  bool has_time() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return settings_.seconds <= 0 || passed.count() < settings_.seconds;
  }

  /// Passes a case to graze; returns the truth.
  Truth put(const Case& put) {
    Judged<Truth> judged = question_.judge(put, tally_.own);
    const bool is_wrong = judged.judgement == test::Judgement::wrong;
    ++tally_.own.cases;
    tally_.own.count("outside", judged.judgement == test::Judgement::outside_range);
    tally_.own.count("wrong", is_wrong);
    if (is_wrong) regressions_.add_failure(Question::row(put, judged.truth));
    if (judged.hardness > hardness_) {
      hardness_ = judged.hardness;
      if (settings_.keeps_hardest) hardest_ = Question::row(put, judged.truth);
    }
    return std::move(judged.truth);
  }

  void put_to_rivals(const Case& put, const Truth& truth) {
    const auto asked = question_.asked(put, truth);
    if (!asked) return;
    bool is_answered = false;
    for (const auto& rival : Question::rivals) {
      const auto answer = Question::ask(rival, *asked);
      if (!answer) continue;
      is_answered = true;
      count(rival.name, *asked, *answer);
    }
    if (is_answered) count("graze", *asked, Question::own_answer(*asked));
  }

  template <class Asked, class Answer>
  void count(std::string_view program, const Asked& asked, const Answer& answer) {
    Figures& figures = tally_.programs[program];
    ++figures.cases;
    Question::mark(asked, answer, figures);
  }

  const Settings& settings_;
  RegressionLog& regressions_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Question question_;
  Tally tally_;
  double hardness_ = 0;
  std::string hardest_;  ///< The row of the hardest case; empty if there was none.
};

/// Adds the tasks of one question that the settings select. They refer to both arguments.
template <class Question>
void add_tasks(const Settings& settings, RegressionLog& regressions, std::vector<Task>& tasks) {
  for (const Subject& subject : Question::subjects()) {
    const std::string name = label(Question::space) + " " + subject.task;
    if (name.find(settings.pairs) == std::string::npos) continue;
    tasks.push_back({name, [&, subject] { return Exam<Question>(subject, settings, regressions).run(); }});
  }
}

}  // namespace graze::exam
